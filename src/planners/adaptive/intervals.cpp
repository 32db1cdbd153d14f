#include "planners/adaptive/intervals.h"

#include <algorithm>

namespace swathplan {
namespace {

constexpr double kTouch = 1e-6;

bool ends_before(const Interval& stretch, double x) { return stretch.high < x; }

}  // namespace

void IntervalSet::add(Interval stretch) {
  if (!(stretch.high > stretch.low)) return;
  auto first =
      std::lower_bound(stretches_.begin(), stretches_.end(), stretch.low - kTouch, ends_before);
  auto last = first;
  while (last != stretches_.end() && last->low <= stretch.high + kTouch) {
    stretch.low = std::min(stretch.low, last->low);
    stretch.high = std::max(stretch.high, last->high);
    ++last;
  }
  if (first == last) {
    stretches_.insert(first, stretch);
    return;
  }
  *first = stretch;
  stretches_.erase(first + 1, last);
}

bool IntervalSet::covers(Interval stretch) const {
  const auto at =
      std::lower_bound(stretches_.begin(), stretches_.end(), stretch.high - kTouch, ends_before);
  return at != stretches_.end() && at->low <= stretch.low + kTouch;
}

double IntervalSet::covered_m(Interval within) const {
  double sum = 0.0;
  auto at = std::lower_bound(stretches_.begin(), stretches_.end(), within.low, ends_before);
  for (; at != stretches_.end() && at->low < within.high; ++at) {
    sum += std::max(0.0, std::min(at->high, within.high) - std::max(at->low, within.low));
  }
  return sum;
}

double IntervalSet::run_end(double from) const {
  const auto at =
      std::lower_bound(stretches_.begin(), stretches_.end(), from - kTouch, ends_before);
  return at != stretches_.end() && at->low <= from + kTouch ? std::max(at->high, from) : from;
}

}  // namespace swathplan

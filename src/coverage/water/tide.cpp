#include "coverage/water/tide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swathplan {

Tide::Tide(std::vector<TideHeight> rows) : rows_(std::move(rows)) {
  const double span = rows_.back().time_s - rows_.front().time_s;
  cosines_ = span / static_cast<double>(rows_.size() - 1) > kHighAndLowWaters;
}

std::optional<double> Tide::height_m(double time_s) const {
  if (time_s < rows_.front().time_s || time_s > rows_.back().time_s) return std::nullopt;
  const auto next = std::upper_bound(rows_.begin() + 1, rows_.end() - 1, time_s,
                                     [](double t, const TideHeight& r) { return t < r.time_s; });
  const TideHeight& a = *(next - 1);
  const TideHeight& b = *next;
  double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  if (cosines_) share = 0.5 - 0.5 * std::cos(std::numbers::pi * share);
  return a.height_m + share * (b.height_m - a.height_m);
}

std::vector<TimeSpan> Tide::spans_above(double least_m) const {
  std::vector<TimeSpan> spans;
  bool above = false;
  const double end = rows_.back().time_s;
  for (double t = rows_.front().time_s;; t = std::min(t + kTideStepS, end)) {
    const bool now = *height_m(t) >= least_m;
    if (now && !above) spans.push_back({t, t});
    if (now) spans.back().to_s = t;
    above = now;
    if (t >= end) break;
  }
  return spans;
}

}  // namespace swathplan

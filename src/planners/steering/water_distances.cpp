#include "planners/steering/water_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace swathplan {
namespace {

constexpr float kUnreached = std::numeric_limits<float>::infinity();
/// Neighbour k of a cell lies this many columns and rows off; neighbour k + 4 lies opposite.
constexpr int kColumnOff[] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kRowOff[] = {0, 1, 1, 1, 0, -1, -1, -1};

}  // namespace

WaterDistances::WaterDistances(const SafeWater& water) : water_(water) { link(); }

void WaterDistances::link() {
  const auto columns = static_cast<std::ptrdiff_t>(water_.columns());
  const auto rows = static_cast<std::ptrdiff_t>(water_.rows());
  links_.assign(water_.cells(), 0);
  for (std::ptrdiff_t i = 0; i < columns * rows; ++i) {
    const Vec2 here = water_.centre(static_cast<std::size_t>(i));
    if (!water_.contains(here)) continue;
    for (int k = 0; k < 4; ++k) {
      const std::ptrdiff_t c = i % columns + kColumnOff[k];
      const std::ptrdiff_t r = i / columns + kRowOff[k];
      if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
      const auto there = static_cast<std::size_t>(r * columns + c);
      if (!water_.holds({here, water_.centre(there)})) continue;
      links_[static_cast<std::size_t>(i)] |= static_cast<unsigned char>(1U << k);
      links_[there] |= static_cast<unsigned char>(1U << (k + 4));
    }
  }
}

template <class Visit>
void WaterDistances::each_seen(const Vec2& p, Visit visit) const {
  const Vec2 at = (p - water_.origin()) / water_.cell_m() - Vec2(0.5, 0.5);
  const auto c0 = static_cast<std::ptrdiff_t>(std::floor(at.x()));
  const auto r0 = static_cast<std::ptrdiff_t>(std::floor(at.y()));
  for (std::ptrdiff_t r = r0; r <= r0 + 1; ++r) {
    for (std::ptrdiff_t c = c0; c <= c0 + 1; ++c) {
      if (c < 0 || r < 0 || c >= static_cast<std::ptrdiff_t>(water_.columns()) ||
          r >= static_cast<std::ptrdiff_t>(water_.rows())) {
        continue;
      }
      const auto i = static_cast<std::size_t>(r) * water_.columns() + static_cast<std::size_t>(c);
      const Vec2 centre = water_.centre(i);
      if (links_[i] != 0 && water_.holds({p, centre})) visit(i, (centre - p).norm());
    }
  }
}

const std::vector<float>& WaterDistances::to(const Vec2& goal) {
  const auto same = std::find(goals_.begin(), goals_.end(), goal);
  const auto number = static_cast<std::size_t>(same - goals_.begin());
  if (same != goals_.end()) return known_.at(number);
  goals_.push_back(goal);
  std::vector<float>& metres = known_[number];
  metres.assign(links_.size(), kUnreached);
  using Item = std::pair<float, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  each_seen(goal, [&](std::size_t i, double away) {
    metres[i] = static_cast<float>(away);
    open.emplace(metres[i], i);
  });
  const auto columns = static_cast<std::ptrdiff_t>(water_.columns());
  while (!open.empty()) {
    const auto [here, i] = open.top();
    open.pop();
    if (here > metres[i]) continue;
    for (int k = 0; k < 8; ++k) {
      if ((links_[i] >> k & 1U) == 0) continue;
      const auto there = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) +
                                                  kRowOff[k] * columns + kColumnOff[k]);
      const float step =
          static_cast<float>(water_.cell_m() * std::hypot(kColumnOff[k], kRowOff[k]));
      if (here + step >= metres[there]) continue;
      metres[there] = here + step;
      open.emplace(metres[there], there);
    }
  }
  return metres;
}

double WaterDistances::from(const Vec2& p, const std::vector<float>& distances) const {
  double best = std::numeric_limits<double>::infinity();
  each_seen(p, [&](std::size_t i, double away) {
    best = std::min(best, away + static_cast<double>(distances[i]));
  });
  return best;
}

}  // namespace swathplan

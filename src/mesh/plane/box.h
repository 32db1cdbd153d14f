#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "mesh/base/frame.h"

namespace swathplan {

/// A box in the horizontal plane, with sides along the axes, metres. Empty until a point is added;
/// the size of an empty box has no meaning.
struct Box2 {
  Vec2 min = Vec2::Constant(1e300);
  Vec2 max = Vec2::Constant(-1e300);
  void extend(const Vec2& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  [[nodiscard]] bool empty() const { return min.x() > max.x(); }
  [[nodiscard]] Vec2 size() const { return max - min; }
};

/// The part of the segment a-b in the box, as parameters within [0, 1]; empty where they are apart.
[[nodiscard]] inline std::optional<std::pair<double, double>> clipped(const Vec2& a, const Vec2& b,
                                                                      const Box2& box) {
  double from = 0.0, to = 1.0;
  for (int k = 0; k < 2; ++k) {
    const double way = b[k] - a[k];
    if (way == 0.0) {
      if (a[k] < box.min[k] || a[k] > box.max[k]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[k] - a[k]) / way;
    const double t1 = (box.max[k] - a[k]) / way;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  return from <= to ? std::optional(std::pair(from, to)) : std::nullopt;
}

}  // namespace swathplan

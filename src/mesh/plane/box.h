#pragma once

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

}  // namespace swathplan

#pragma once

#include <cmath>
#include <optional>

#include "mesh/base/frame.h"

namespace swathplan {

/// z of the cross product, positive where b points to the left of a; 0 where they are parallel or
/// one of them is zero.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The change from the course `in` to the course `out`, radians in [-pi, pi], positive to port. The
/// vectors may have any length. +pi or -pi where `out` runs straight back. Without meaning (0, pi
/// or -pi) where one of them is zero.
[[nodiscard]] inline double turn_angle(const Vec2& in, const Vec2& out) {
  return std::atan2(cross(in, out), in.dot(out));
}

/// A place on a segment.
struct SegmentPlace {
  double share;  ///< of the way from the segment's first end to its second, [0, 1]
  Vec2 point;
};

/// The place on the segment a-b that is nearest to p. A segment without a length is its first end,
/// share 0. Coordinates that are not finite give places that are not.
[[nodiscard]] SegmentPlace nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p);

/// The share of the way from a to b at which the segment c-d crosses it, [0, 1); c-d counts in [0,
/// 1) too, so that a crossing at a corner of a path counts once. Empty where they do not cross, and
/// for parallels.
[[nodiscard]] inline std::optional<double> crossing(const Vec2& a, const Vec2& b, const Vec2& c,
                                                    const Vec2& d) {
  const double area = cross(b - a, d - c);
  if (area == 0.0) return std::nullopt;
  const double along = cross(c - a, d - c) / area;
  const double across = cross(c - a, b - a) / area;
  const bool meet = along >= 0.0 && along < 1.0 && across >= 0.0 && across < 1.0;
  return meet ? std::optional(along) : std::nullopt;
}

/// Metres from p to the segment a-b. A segment without a length is a point.
[[nodiscard]] double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p);

}  // namespace swathplan

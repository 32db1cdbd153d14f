#include "mesh/plane/segments.h"

#include <algorithm>

namespace swathplan {

SegmentPlace nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return {t, a + t * d};
}

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (nearest_on_segment(a, b, p).point - p).norm();
}

}  // namespace swathplan

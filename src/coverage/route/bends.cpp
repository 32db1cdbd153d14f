#include "coverage/route/bends.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/base/angle.h"
#include "mesh/plane/segments.h"

namespace swathplan {

CourseChange course_change(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 in = b - a;
  const Vec2 out = c - b;
  return {in.norm(), out.norm(), turn_angle(in, out)};
}

bool is_corner(const CourseChange& change, double turn_radius_m) {
  const double angle = std::abs(change.angle_rad);
  if (angle <= Angle::degrees(kCornerDeg).rad()) return false;
  if (std::min(change.before_m, change.after_m) > kLongestChordM) return true;
  return turn_radius_m * (1.0 / std::cos(0.5 * angle) - 1.0) > kCornerMissM;
}

double bend_radius_m(const CourseChange& change, double turn_radius_m) {
  if (is_corner(change, turn_radius_m)) return 0.0;
  const double tangent = std::tan(0.5 * std::abs(change.angle_rad));
  const double half = 0.5 * std::min(change.before_m, change.after_m);
  return tangent > 0.0 ? half / tangent : std::numeric_limits<double>::infinity();
}

double turn_path_m(const CourseChange& change, double turn_radius_m) {
  return std::min(0.5 * (change.before_m + change.after_m),
                  turn_radius_m * std::abs(change.angle_rad));
}

}  // namespace swathplan

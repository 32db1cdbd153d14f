#pragma once

#include <string>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan::internal {

/// A stretch of a route that is drawn in one way.
struct DisplayPath {
  LegKind kind = LegKind::line;
  bool log = true, sonar = true;
  std::vector<Vec2> points;
};

/// The route for drawing. Neighbouring legs that look alike are joined. Points that lie within
/// `tolerance_m` of the remaining line are left out (Douglas-Peucker).
[[nodiscard]] std::vector<DisplayPath> display_path(const Route& route, double tolerance_m);

/// The points of a line that stay: the first, the last and those that Douglas-Peucker keeps.
[[nodiscard]] std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m);

}  // namespace swathplan::internal

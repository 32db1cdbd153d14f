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

/// The route for drawing: neighbouring legs that look alike joined, points left out that lie within
/// `tolerance_m` of the line that is left (Douglas-Peucker).
[[nodiscard]] std::vector<DisplayPath> display_path(const Route& route, double tolerance_m);

/// The points of a line that stay: the first, the last and what Douglas-Peucker needs.
[[nodiscard]] std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m);

}  // namespace swathplan::internal

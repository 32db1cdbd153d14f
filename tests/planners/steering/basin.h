#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "mesh/plane/polygons.h"
#include "planners/steering/line_poses.h"

namespace swathplan {

/// Open water from (0, 0) to (width, height).
inline Area basin(double width_m, double height_m) {
  return {{Ring{{0, 0}, {width_m, 0}, {width_m, height_m}, {0, height_m}}, {}}};
}

/// The smallest turn radius that a point of the path asks for, metres.
inline double tightest(const std::vector<Vec2>& path) {
  const LinePoses line(path);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.points().size(); ++i) {
    least = std::min(least, line.radius_at(i, 0.0));
  }
  return least;
}

}  // namespace swathplan

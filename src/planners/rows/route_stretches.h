#pragma once

#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// A stretch of a route: a line or the join after it. The last waypoint of a line is its end. A
/// join does not hold the place where the next line begins.
struct RouteStretch {
  std::vector<Waypoint> points;
  bool join = false;
};

/// Divides a route into stretches, one for each leg of a line. A turn and a transit in a row are
/// one join.
[[nodiscard]] std::vector<RouteStretch> stretches(const Route& route);

}  // namespace swathplan

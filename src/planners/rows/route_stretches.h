#pragma once

#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// A stretch of a route: a line, whose last waypoint is where it ends, or the join after it as it
/// stands, without the place where the next line begins.
struct RouteStretch {
  std::vector<Waypoint> points;
  bool join = false;
};

/// The route in stretches, one a leg of a line; a turn and a transit in a row are one join.
[[nodiscard]] std::vector<RouteStretch> stretches(const Route& route);

}  // namespace swathplan

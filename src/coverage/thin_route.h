#pragma once

#include "coverage/route.h"

namespace swathplan {

/// A route with fewer waypoints.
struct ThinnedRoute {
  Route route;
  double largest_distance_m = 0.0;  ///< between its path and that of the whole route; measured
};

/// The route for those who cannot take every waypoint of it (see thin_path): the ends of legs and
/// the waypoints where the speed changes stay; fans that change within a leg are lost.
/// Guarantees: (1) largest_distance_m <= tolerance_m; (2) the waypoints are some of the route's, in
/// its order; (3) legs(...) of both begin and end at the same waypoints.
[[nodiscard]] ThinnedRoute thin_route(const Route& route, double tolerance_m);

}  // namespace swathplan

#pragma once

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// A route with fewer waypoints.
struct ThinnedRoute {
  Route route;
  double largest_distance_m = 0.0;  ///< between its path and that of the whole route; measured
};

/// The route for those who cannot take every waypoint of it (see thin_path): the ends of legs and
/// the waypoints where the speed changes stay; fans that change within a leg are lost.
/// Guarantees: (1) largest_distance_m <= tolerance_m; (2) the waypoints are some of the route's, in
/// its order; (3) legs(...) of both begin and end at the same waypoints; (4) where `water` is
/// given, no segment that leaves out waypoints runs outside it for longer than the route does
/// there, but for a millimetre.
[[nodiscard]] ThinnedRoute thin_route(const Route& route, double tolerance_m,
                                      const AreaQuery* water = nullptr);

}  // namespace swathplan

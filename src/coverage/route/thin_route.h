#pragma once

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// A route with fewer waypoints.
struct ThinnedRoute {
  Route route;
  double largest_distance_m = 0.0;  ///< between its path and that of the whole route, as measured
};

/// The route with fewer waypoints, for autopilots that cannot take them all (see thin_path). Ends
/// of legs stay, and so do waypoints where the speed changes. Fans that change within a leg are
/// lost.
/// Guarantees: (1) largest_distance_m <= tolerance_m; (2) the waypoints are some of the route's, in
/// its order; (3) legs(...) of both begin and end at the same waypoints; (4) with `water`, a
/// segment that replaces several runs outside it no more than a millimetre longer than they do;
/// (5) no curve between long straights becomes a corner (is_corner).
[[nodiscard]] ThinnedRoute thin_route(const Route& route, double tolerance_m,
                                      const AreaQuery* water = nullptr);

}  // namespace swathplan

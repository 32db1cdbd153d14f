#pragma once

#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// A route thinned for programs that sail straight in longitude and latitude between waypoints.
struct GeographicRoute {
  Route route;                ///< its legs begin and end where those of the whole route do
  std::vector<Vec2> lonlat;   ///< WGS84 degrees of each waypoint, longitude in [-180, 180]
  double largest_distance_m;  ///< bounds the distance between its path and that of the whole route
};

/// Thins a route (see thin_route, for `water` too) and divides segments so long that a parallel or
/// rhumb line between their ends would leave the planned straight. Guarantees: (1)
/// largest_distance_m <= tolerance_m (but for 0.1 mm of rounding in files); (2) it counts what was
/// left out and the bend of the divided segments, both measured.
/// @throws InvalidInput if the frame has no CRS or a point has no place in WGS84.
[[nodiscard]] GeographicRoute geographic_route(const Route& route, const Frame& frame,
                                               double tolerance_m,
                                               const AreaQuery* water = nullptr);

}  // namespace swathplan

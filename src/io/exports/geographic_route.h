#pragma once

#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// A route thinned for programs that sail straight in longitude and latitude between waypoints.
struct GeographicRoute {
  Route route;                ///< its legs begin and end where those of the whole route do
  std::vector<Vec2> lonlat;   ///< WGS84 degrees of each waypoint, longitude in [-180, 180]
  double largest_distance_m;  ///< no point of its path lies farther from that of the whole route
};

/// Thins a route (see thin_route, also for `water`). Then it divides long segments: a rhumb line
/// between the ends of a long segment would leave the planned straight line.
/// Guarantees: (1) largest_distance_m <= tolerance_m; files round it by 0.1 mm. (2)
/// largest_distance_m counts both the waypoints that were left out and the bend of the segments.
/// Both are measured.
/// @throws InvalidInput if the frame has no CRS or a point has no place in WGS84.
[[nodiscard]] GeographicRoute geographic_route(const Route& route, const Frame& frame,
                                               double tolerance_m,
                                               const AreaQuery* water = nullptr);

}  // namespace swathplan

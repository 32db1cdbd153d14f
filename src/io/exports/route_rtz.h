#pragma once

#include <cstddef>
#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The largest file that the standard lets a chart system take.
inline constexpr std::size_t kRtzBytes = 400UL * 1024UL;

/// The route in the route exchange format RTZ 1.0 of chart systems (IEC 61174:2015): numbered and
/// named waypoints, rhumb-line legs with the planned speed as `speedMax` in knots, and the radius
/// of each turn in nautical miles. A waypoint's leg is the one that leads to it.
/// `name` must be that of the file without its extension.
/// A turn's radius is the largest whose circle leaves the corner by no more than `tolerance_m` and
/// takes no more than half of the legs beside it; left out, a chart system would put its own.
[[nodiscard]] std::string route_rtz(const GeographicRoute& route, const std::string& name,
                                    double tolerance_m);

}  // namespace swathplan

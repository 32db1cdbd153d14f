#pragma once

#include <cstddef>
#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The largest file that the standard lets a chart system take.
inline constexpr std::size_t kRtzBytes = 400UL * 1024UL;

/// The route in RTZ 1.0, the route exchange format of chart systems (IEC 61174:2015). Waypoints
/// have numbers and names. Legs are rhumb lines; `speedMax` is their planned speed in knots. A
/// waypoint's leg is the one that leads to it. Each turn has a radius in nautical miles. `name`
/// must be that of the file without its extension. The radius is the largest that satisfies two
/// rules: the circle passes the corner at no more than `tolerance_m`, and it takes no more than
/// half of each leg beside it. Without a radius, a chart system would use its own.
[[nodiscard]] std::string route_rtz(const GeographicRoute& route, const std::string& name,
                                    double tolerance_m);

}  // namespace swathplan

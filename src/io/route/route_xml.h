#pragma once

#include <string>
#include <string_view>

#include "io/route/foreign_route.h"

namespace swathplan {

/// Reads XML of these kinds, told apart by their outermost element; `file` is what messages call
/// it.
/// - GPX: the points of all routes; of the tracks where it has no route; else its waypoints.
/// - KML: lines and tracks in their order, or places where it has no line.
/// - RTZ: the waypoints of a chart system's route, with speeds.
/// @throws InvalidInput for any other XML, or a place that is not given by numbers.
[[nodiscard]] ForeignRoute parse_route_xml(std::string_view text, const std::string& file);

}  // namespace swathplan

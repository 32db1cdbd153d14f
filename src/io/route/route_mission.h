#pragma once

#include <string>
#include <string_view>

#include "io/route/foreign_route.h"

namespace swathplan {

/// Reads a MAVLink mission as text ('QGC WPL 110'); `file` is what messages call it. Row 0 is home
/// and no part of the route. Waypoints of all kinds count, and changes of speed; other commands are
/// left out and counted.
/// @throws InvalidInput for a broken row, places that are not in degrees, or loops.
[[nodiscard]] ForeignRoute parse_mission_waypoints(std::string_view text, const std::string& file);

/// Reads a plan of QGroundControl (JSON, .plan): its mission items, and what surveys and corridors
/// hold as items of their own.
/// @throws InvalidInput for anything else, or a survey without items.
[[nodiscard]] ForeignRoute parse_mission_plan(std::string_view text, const std::string& file);

}  // namespace swathplan

#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The route as a plan of QGroundControl (JSON, version 1) for a boat on ArduPilot: its items are
/// those of mission_waypoints. Home is the first waypoint. Fence and rally points are empty.
[[nodiscard]] std::string mission_plan(const GeographicRoute& route);

}  // namespace swathplan

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// One file of a MAVLink mission.
struct Mission {
  std::string text;
  std::size_t items;  ///< all of them, the home position too
};

/// The most items that ArduPilot's boards with 16 kB of storage hold for boats and rovers, home
/// included (StorageManager.cpp).
inline constexpr std::size_t kArduPilotItems = 724;
/// The smallest part a mission can be cut into: home, a speed and two waypoints.
inline constexpr std::size_t kFewestItems = 4;

/// The route as MAVLink plain-text missions ('QGC WPL 110'): home at the first waypoint, then
/// NAV_WAYPOINT items at altitude 0 relative to home, and DO_CHANGE_SPEED before the waypoint to
/// which a leg of another speed leads. Acceptance radius and holding time are left to the vehicle.
/// One mission; with `most_items` > 0 as many as are needed for none to hold more. A mission then
/// begins where the one before ends, if it can at the end of a survey line. `most_items` is 0 or
/// at least kFewestItems.
[[nodiscard]] std::vector<Mission> mission_waypoints(const GeographicRoute& route,
                                                     std::size_t most_items = 0);

}  // namespace swathplan

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// An item of a mission: a speed to set, or a place to sail to.
struct MissionItem {
  std::optional<double> speed_mps;
  Vec2 lonlat = Vec2::Zero();  ///< of a place
};

/// The items that lead from a waypoint of the route to a later one. A speed stands before the
/// waypoint to which its leg leads.
[[nodiscard]] std::vector<MissionItem> mission_items(const GeographicRoute& route,
                                                     std::size_t first, std::size_t last);

/// One file of a MAVLink mission.
struct Mission {
  std::string text;
  std::size_t items;  ///< all of them, the home position too
};

/// The most items of a mission for boats and rovers on ArduPilot's boards with 16 kB of storage.
/// Home counts too. The number comes from ArduPilot's StorageManager.cpp.
inline constexpr std::size_t kArduPilotItems = 724;
/// The smallest part a mission can be cut into: home, a speed and two waypoints.
inline constexpr std::size_t kFewestItems = 4;

/// The route as MAVLink plain-text missions ('QGC WPL 110'). Home is the first waypoint.
/// NAV_WAYPOINT items follow at altitude 0 relative to home. Where the speed changes,
/// DO_CHANGE_SPEED stands before the waypoint to which the leg leads. The vehicle chooses
/// acceptance radius and holding time. `most_items` is 0 or at least kFewestItems. With 0 there is
/// one mission. Otherwise the route is cut into missions that hold no more items each. A mission
/// begins where the one before ends, at the end of a survey line if possible.
[[nodiscard]] std::vector<Mission> mission_waypoints(const GeographicRoute& route,
                                                     std::size_t most_items = 0);

}  // namespace swathplan

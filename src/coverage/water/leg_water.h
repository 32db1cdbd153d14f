#pragma once

#include <optional>
#include <vector>

#include "coverage/route/route.h"
#include "coverage/route/route_figures.h"
#include "coverage/route/vehicle.h"
#include "coverage/water/tide.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// When a leg is sailed and how much water it has. Depths count from the level of the seafloor's
/// frame, heights of the tide too.
struct LegWater {
  Leg leg{};
  double start_s = 0.0, end_s = 0.0;  ///< after the departure
  /// Least depth below the leg; empty where the data hold none below some of it.
  std::optional<double> least_depth_m;
  /// Least depth with the tide of the time when it is sailed, less the draft; empty without a
  /// depth, a tide or a departure, or beyond the tide's table.
  std::optional<double> under_keel_m;
  /// Then the depth is less than the vehicle's safe one; empty where under_keel_m is.
  std::optional<bool> short_of_water;
  std::vector<TimeSpan> windows;  ///< in the tide's table, when all of it has the safe depth
};

/// Where a boat sets out in the route of a job of several sorties, and when.
struct Beginning {
  std::size_t waypoint = 0;  ///< its first one
  double begins_s = 0.0;     ///< after the departure
};

/// What legs are sailed by.
struct Sailing {
  const Tide* tide = nullptr;         ///< null: still water
  std::optional<double> departure_s;  ///< since 1970-01-01 00:00 UTC
  /// By waypoint, rising. Before the first one, and without any, the clock runs from the departure.
  std::vector<Beginning> beginnings = {};
};

/// The legs of a route in their order, parted where a sortie begins. Depths are looked up at least
/// each kDepthStepM of path.
[[nodiscard]] std::vector<LegWater> water_of_legs(const Route& route, const Vehicle& vehicle,
                                                  const DepthQuery& depths, const Sailing& sailing);

/// Adds the least water under the keel, of all legs and of each line, to the figures of the route.
void add_water(const Route& route, const std::vector<LegWater>& legs, RouteFigures& figures);

}  // namespace swathplan

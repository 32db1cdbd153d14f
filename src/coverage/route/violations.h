#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coverage/route/route.h"
#include "coverage/route/vehicle.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// Why a stretch of a route must not be sailed as it is drawn.
enum class ViolationKind {
  infeasible,     ///< the planner found no way that the vehicle can steer in safe water
  outside_water,  ///< outside safe water or inside no-go
  tight_turn      ///< bends tighter than the vehicle can, and no planner marked it
};
[[nodiscard]] std::string_view name(ViolationKind kind);

/// A stretch of the route, from waypoint `first` to waypoint `last`.
struct Violation {
  ViolationKind kind = ViolationKind::infeasible;
  std::size_t first = 0, last = 0;  ///< waypoint indices, first < last
  double length_m = 0.0;            ///< the part of the stretch that violates
  Vec2 position = Vec2::Zero();     ///< halfway along the stretch, local metres
  double radius_m = 0.0;            ///< of a tight turn: its smallest, as in bends.h
  double over_land_m = 0.0;         ///< of an infeasible stretch: over land or no-go
};

/// All violations of a route: infeasible legs first, then stretches outside the water, then tight
/// turns; each kind in sailing order. Guarantees: (1) as many infeasible ones as
/// RouteFigures::infeasible_legs; (2) the lengths outside the water add up to outside_water_m.
[[nodiscard]] std::vector<Violation> violations(const Route& route, const Vehicle& vehicle,
                                                const Area& water, const Area& land = {});

/// What is wrong with the stretch, in words for the user, without a full stop.
[[nodiscard]] std::string reason(const Violation& violation, const Route& route,
                                 const Vehicle& vehicle);

}  // namespace swathplan

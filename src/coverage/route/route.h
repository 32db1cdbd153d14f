#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// What a leg is for: a `patch` line is sailed to calibrate the sonar, `end` marks the last
/// waypoint only.
enum class LegKind { line, turn, transit, cross, infill, patch, run_in, run_out, end };
/// True for kinds that are there to sound the ground: line, cross, infill and patch.
[[nodiscard]] bool is_survey(LegKind kind);
[[nodiscard]] std::string_view name(LegKind kind);
/// Empty for a name that is none of the kinds.
[[nodiscard]] std::optional<LegKind> leg_kind(std::string_view name);

/// Half-angles of the fan from nadir.
struct FanAngles {
  Angle port, starboard;
  bool operator==(const FanAngles&) const = default;
};

/// A point of the route and what holds from it to the next one.
struct Waypoint {
  Vec2 position = Vec2::Zero();  ///< local metres
  LegKind kind = LegKind::line;
  bool log = true;               ///< data is kept
  std::optional<int> line;       ///< number of the survey line
  std::optional<FanAngles> fan;  ///< empty: sonar off
  double speed_mps = 2.0;
  std::optional<int> region;  ///< depth region
  bool feasible = true;       ///< false: no way that the vehicle can steer in safe water was found
};

/// A route: straight segments between waypoints. Waypoints stand so densely that these segments are
/// the path.
struct Route {
  std::vector<Waypoint> waypoints;
};

/// The positions of waypoints, in their order.
[[nodiscard]] std::vector<Vec2> positions(const std::vector<Waypoint>& waypoints);

[[nodiscard]] double length_m(const Route& route);

/// The longest run of waypoints that share line, kind, log, region, feasible, and whether the sonar
/// is on. Its last point is the first waypoint of the next leg.
struct Leg {
  std::size_t first, last;  ///< waypoint indices, first < last
};
[[nodiscard]] std::vector<Leg> legs(const Route& route);

/// The first fault of a route; empty for a valid one. A valid route has at least two waypoints,
/// finite positions, angles in (0, 90) degrees, positive speeds, and the kind `end` at its last
/// waypoint only.
[[nodiscard]] std::optional<std::string> fault(const Route& route);

}  // namespace swathplan

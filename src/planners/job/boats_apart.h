#pragma once

#include <optional>
#include <vector>

#include "planners/job/job_order.h"
#include "planners/job/sorties.h"

namespace swathplan {

/// A route that a boat begins at some time.
struct TimedRoute {
  double begins_s = 0.0;
  const Route* route = nullptr;
};
/// What a boat sails, sortie after sortie.
using BoatTrack = std::vector<TimedRoute>;

/// How near boats come to each other while they survey.
struct BoatsApart {
  /// Seconds that two boats on lines of the main scheme are nearer to each other than the mean of
  /// their swaths.
  double within_a_swath_s = 0.0;
  double neighbours_s = 0.0;           ///< seconds that two boats are on neighbouring lines
  std::optional<double> least_m = {};  ///< between two boats on lines; empty: never two are
};

/// Width of the swath of a line, metres: the mean over its waypoints, from its fans and the depths
/// below.
[[nodiscard]] double swath_of(const std::vector<Waypoint>& points, const Ground& ground,
                              const Vehicle& vehicle);

/// Two lines are neighbours if they come nearer to each other than the mean of their swaths, so
/// that the swaths touch. Cross-lines and patch lines have no neighbours.
[[nodiscard]] bool neighbours(const JobLine& a, const JobLine& b, double swath_m);

/// Watches boats over the whole time. O(legs at the same time x their waypoints).
[[nodiscard]] BoatsApart boats_apart(const std::vector<BoatTrack>& tracks, const Ground& ground,
                                     const Vehicle& vehicle);

/// The boats' lines in orders that keep them off neighbouring lines at the same time, as far as the
/// estimate tells: each boat's order is kept, turned round, or has single lines moved. `fixed`: so
/// many lines of the first boat come first, whatever happens.
[[nodiscard]] std::vector<SortieLines> kept_apart(std::vector<SortieLines> boats, std::size_t fixed,
                                                  const Ground& ground, const Vehicle& vehicle,
                                                  const JobWays& ways, const Vec2& berth);

}  // namespace swathplan

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planners/adaptive/accordion.h"

namespace swathplan {

/// The accordion's abstract world: a flat seafloor of strips. Some strips hold an object, which
/// every look shows. As in the paper, costs are 1 where an object lies and 0.1 elsewhere.
struct StripWorld {
  std::vector<double> objects_m;  ///< ascending, across axis
};
/// Strips of `spacing_m` over `width_m`. Exactly round(share x strips) of them, chosen at random,
/// hold one object each. It lies at a random place, at least an eighth of the strip from its edges.
/// @throws UsageError if the share lies outside [0, 1].
[[nodiscard]] StripWorld random_strips(double width_m, double spacing_m, double share,
                                       std::uint64_t seed);

[[nodiscard]] AccordionObservation observe_world(const StripWorld& world,
                                                 const AccordionOptions& options,
                                                 const SurveyTrack& track);

/// A simulated mission from its first track to its last.
struct AccordionMission {
  AccordionState state{};
  int objects = 0;
  int objects_seen_twice = 0;  ///< looked at from both sides
};
[[nodiscard]] AccordionMission sail(const StripWorld& world, const AccordionOptions& options);

/// Improvement on the overlapping lawnmower in percent, positive where the mission is shorter.
/// `whole` counts every track. `periods` counts up to the arrival at the far edge, as the paper
/// counts its spatial periods: the closing tracks there are left out, of the lawnmower as well.
struct AccordionGain {
  double whole_pct = 0.0, periods_pct = 0.0;
};
[[nodiscard]] AccordionGain gain(const AccordionState& state);

}  // namespace swathplan

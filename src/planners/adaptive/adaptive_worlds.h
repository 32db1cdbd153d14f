#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planners/adaptive/accordion.h"

namespace swathplan {

/// Uniform numbers that are the same on every machine: a counter hashed with a seed, no state
/// shared between missions.
class SeededNumbers {
 public:
  explicit SeededNumbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [0, 1).
  double uniform();
  /// In [0, count), count > 0.
  std::size_t below(std::size_t count);
  /// Standard normal.
  double normal();

 private:
  std::uint64_t state_;
};
/// A seed of its own for each (cell, repeat) of a study.
[[nodiscard]] std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t a, std::uint64_t b = 0);

/// The accordion's abstract world: a flat seafloor of strips, some with an object that any look
/// shows. Costs are 0.1 where nothing is and 1 where an object lies, as in the paper.
struct StripWorld {
  std::vector<double> objects_m;  ///< ascending, across axis
};
/// Strips of `spacing_m` over `width_m`; exactly round(share x strips) of them, chosen at random,
/// hold one object at a random place, at least an eighth of the strip away from its edges.
/// @throws UsageError if the share lies outside [0, 1].
[[nodiscard]] StripWorld random_strips(double width_m, double spacing_m, double share,
                                       std::uint64_t seed);
/// One object in the middle of each strip listed.
[[nodiscard]] StripWorld chosen_strips(double spacing_m, std::span<const int> strips);

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

/// Improvement on the overlapping lawnmower in percent, positive where shorter. `whole`: every
/// track counted. `periods`: up to the arrival at the far edge, the closing tracks there left out
/// on both sides, as the paper counts its spatial periods.
struct AccordionGain {
  double whole_pct = 0.0, periods_pct = 0.0;
};
[[nodiscard]] AccordionGain gain(const AccordionState& state);

}  // namespace swathplan

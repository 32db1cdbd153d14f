#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "planners/adaptive/intervals.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// Which rule lays the next track.
enum class AccordionRule {
  basic,   ///< the published algorithm: always skips a strip in the hope that it is empty
  bounded  ///< skips a track only while skipping pays on average, and while even the worst outcome
           ///< is longer than the overlapping lawnmower by no more than one track
};

struct AccordionOptions {
  double width_m = 0.0;      ///< of the area, across the tracks, > 0
  double length_m = 0.0;     ///< of a track, > 0
  double spacing_m = 50.0;   ///< strip width W: tracks lie W or 2 W apart, > 0
  double nadir_gap_m = 0.0;  ///< half-width of the blind strip below the sonar, [0, spacing_m)
  double threshold = 0.5;    ///< a cost above it is an object of interest, >= 0
  AccordionRule rule = AccordionRule::basic;
  /// How far an object may lie from where the cost map shows it, >= 0. The bounded rule lays tracks
  /// by the places of objects, so it keeps them this far inside the sonar's limits.
  double clearance_m = 0.0;
};
/// @throws UsageError if an option breaks its rule; the message names it.
void check(const AccordionOptions& options);

/// Sonar range that the spacing needs: W + nadir gap. A neighbouring track then sees the blind
/// strip below a track.
[[nodiscard]] double sonar_range_m(const AccordionOptions& options);

/// Cost map of one side of a track: rows along the track, columns from the track outwards, the
/// first one at `first_m` and each `step_m` wide. Costs are finite and >= 0.
struct CostMap {
  int rows = 0, columns = 0;
  double first_m = 0.0, step_m = 1.0;
  std::vector<float> values;  ///< rows x columns, row by row
  /// Width next to the track where nothing looked: the nadir gap of a vehicle without a gap filler.
  /// What lies nearer than `first_m` counts as blind as well.
  double blind_m = 0.0;
  double along_m = 0.0;  ///< metres of track that the rows span; 0: the whole track

  /// Index of a value; rows x columns is index(rows, 0).
  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};
/// What a sailed track saw: `back` towards the start edge, `ahead` towards the far edge.
struct AccordionObservation {
  CostMap back, ahead;
};

/// The state of a mission; plain data. It begins as start_accordion(options).
struct AccordionState {
  AccordionOptions options;
  std::vector<SurveyTrack> sailed;
  IntervalSet seen_from_below;    ///< looked at from a smaller `across_m`
  IntervalSet seen_from_above;    ///< looked at from a larger `across_m`
  std::vector<Interval> pending;  ///< objects not yet seen from both sides, across axis
  double front_m = 0.0;           ///< farthest track so far
  double sailed_m = 0.0;          ///< tracks and connectors, from the start corner
  // From these the bounded rule estimates how often a skip succeeds.
  int strips_seen = 0, strips_with_objects = 0;  ///< strips seen for the first time
  int loops = 0;                                 ///< how often a track went back
  double loops_m = 0.0;                          ///< way there and back, without the tracks
};

[[nodiscard]] AccordionState start_accordion(const AccordionOptions& options);

/// The next track. Empty when the area is done: all of it is seen, and every object from both
/// sides. Tracks alternate in direction. The same state always gives the same track.
[[nodiscard]] std::optional<SurveyTrack> next_track(const AccordionState& state);

/// The state after `track` was sailed.
///
/// Only what was looked at counts. A blind strip below the track is kept like an object, so that
/// both neighbours look at it.
/// @throws InvalidInput if `track` is not next_track(state), or if a cost map has the wrong size,
/// begins beyond the nadir gap, does not reach the sonar range, spans another length than the
/// track's (by more than a twentieth and a metre), or holds a NaN, infinite or negative cost.
[[nodiscard]] AccordionState observe(AccordionState state, const SurveyTrack& track,
                                     const AccordionObservation& observation);

/// The overlapping lawnmower (CL-CPP): tracks at 0, W, 2 W, ... and at the far edge.
[[nodiscard]] std::vector<SurveyTrack> overlapping_lawnmower(double width_m, double spacing_m);

/// The accordion's mean improvement on the lawnmower in percent, as the paper fitted it (its
/// eq. 4); `alpha` = W / length, `p_obj_pct` in [0, 100].
[[nodiscard]] double published_improvement_pct(double alpha, double p_obj_pct);

}  // namespace swathplan

#pragma once

#include <cstdint>
#include <vector>

#include "planners/adaptive/residual_risk.h"
#include "planners/adaptive/track_spacing.h"

namespace swathplan {

/// The abstract world of the track-spacing planner: a flat seafloor, one true P(y) curve.
struct SpacingWorld {
  DetectionCurve truth = example_curve();
  /// Number of targets per range bin and track from which the curve is estimated. 0: the planner
  /// gets the true curve.
  int trials = 0;
  double bin_m = 5.0;
  double scatter = 0.1;  ///< see RiskMapOptions
  std::uint64_t seed = 1;
};

struct SpacingMission {
  TrackSpacingState state;
  ResidualRiskMap risk;  ///< over the whole area
};
[[nodiscard]] SpacingMission sail(const TrackSpacingOptions& options, const SpacingWorld& world);

/// What one track of this world lets the vehicle estimate.
[[nodiscard]] DetectionCurve observe_world(const SpacingWorld& world, const SurveyTrack& track);

}  // namespace swathplan

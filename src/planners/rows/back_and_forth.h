#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Lines stop this far before the outline, metres: just enough that rounding keeps them in the
/// water.
inline constexpr double kLineInset = 0.05;
inline constexpr int kFewRows = 8;

/// Back-and-forth (B&F), today's baseline: parallel lines at spacing W along one direction (the
/// one with the fewest lines, or `heading`), one opening angle from the mean depth of the whole
/// area. The rows are centred; where no more than kFewRows fit, where they happen to fall decides
/// over points of coverage, so of several placements (and with a scene) the simulator chooses, and
/// a note says which. Turns and transits between lines stay in the water, ping, and are not logged.
/// @throws UsageError for options out of range.
[[nodiscard]] Plan plan_back_and_forth(const PlanningGround& ground, const PlanOptions& options);

}  // namespace swathplan

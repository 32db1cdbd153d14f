#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Lines stop this far before the outline, metres, so that rounding keeps them in the water.
inline constexpr double kLineInset = 0.05;
inline constexpr int kFewRows = 8;

/// Back-and-forth (B&F), today's baseline. Parallel lines run along one direction: the one with the
/// fewest lines, or `heading`. With SwathBy::footprint they lie W apart, with the opening angle
/// that follows from the mean depth of the whole area. With SwathBy::fan all have one fan, and lie
/// apart by the area's depth, fan and overlap, or by the spacing given (line_spacing.h); a note
/// says so. No line is shorter than `least_line_m`. The rows are centred. Where no more than
/// kFewRows fit, their place changes the coverage by several points. So, with a scene, the
/// simulator chooses among several placements, and a note names the one. Turns and transits between
/// lines stay in the water, ping, and are not logged.
/// @throws UsageError for options out of range.
[[nodiscard]] Plan plan_back_and_forth(const Ground& ground, const PlanOptions& options);

}  // namespace swathplan

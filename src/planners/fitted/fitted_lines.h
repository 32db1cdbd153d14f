#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Survey lines fitted to the seafloor with the simulator in the loop. Candidates (lines of many
/// directions and numbers, spaced by the gap-free swath; lines along the level sets of a front;
/// lines laid edge to edge) are built into routes with asymmetric fans, scored, and varied where
/// they are best; the best get extra passes over the gaps that are left. What no other plan beats
/// in both length and coverage is kept in `Plan::choices`, and `options.goal` picks the route.
/// Without a scene it takes the first candidate: lines along the area's long side.
/// Guarantees: (1) no line leaves the water; (2) the choices are sorted by length and by coverage;
/// (3) the same plan for any number of threads.
[[nodiscard]] Plan plan_fitted_lines(const PlanningGround& ground, const PlanOptions& options);

}  // namespace swathplan

#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Survey lines fitted to the seafloor with the simulator in the loop. Candidates are straight
/// lines of many directions and numbers, spaced by the gap-free swath; lines along the level sets
/// of a front; and lines laid edge to edge. They are built into routes with asymmetric fans and
/// scored. The best ones are varied, and get extra passes over the gaps that are left.
/// `Plan::choices` keeps the plans that no other plan beats in both length and coverage.
/// `options.goal` picks the route. Without a scene the first candidate is taken: lines along the
/// area's long side. Guarantees: (1) no line leaves the water; (2) the choices are sorted by length
/// and by coverage; (3) the same plan for any number of threads.
[[nodiscard]] Plan plan_fitted_lines(const Ground& ground, const PlanOptions& options);

}  // namespace swathplan

#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Multi-depth NUC: the planning mesh is split into depth regions, all edges between regions but
/// the gates are blocked, and one NUC path runs through them, each region with one opening angle
/// from its own mean depth.
/// Guarantees: those of nuc_skeleton(); each gate is crossed once in and once out.
/// Method: [larrazabal-mdnuc] section III.B.
/// @throws UsageError for options out of range or bands that hold no face.
[[nodiscard]] Plan plan_mdnuc(const PlanningGround& ground, const PlanOptions& options);

}  // namespace swathplan

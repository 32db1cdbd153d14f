#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Multi-depth NUC. The planning mesh is split into depth regions. All edges between regions are
/// blocked, except the gates. One NUC path runs through all regions. Each region has one opening
/// angle from its own mean depth.
/// Guarantees: those of nuc_skeleton(); each gate is crossed once in and once out.
/// Method: [larrazabal-mdnuc] section III.B.
/// @throws UsageError for options out of range or bands that hold no face.
[[nodiscard]] Plan plan_mdnuc(const Ground& ground, const PlanOptions& options);

}  // namespace swathplan

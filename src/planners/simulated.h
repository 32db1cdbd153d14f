#pragma once

#include "planners/plan.h"

namespace swathplan {

/// What a candidate route brings by hits on the seafloor of `ground`, which must hold its scene,
/// with the sonar, cells, pings and noise of `options`; `what` is left empty.
[[nodiscard]] Outcome simulated_hits(const Route& route, const PlanningGround& ground,
                                     const PlanOptions& options);

}  // namespace swathplan

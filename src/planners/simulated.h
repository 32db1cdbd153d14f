#pragma once

#include "planners/plan.h"

namespace swathplan {

/// The outcome of a candidate route by hits, simulated with the sonar, cells, pings, noise
/// and counted soundings of `options`. `ground` must hold its scene. `what` stays empty.
[[nodiscard]] Outcome simulated_hits(const Route& route, const Ground& ground,
                                     const PlanOptions& options);

}  // namespace swathplan

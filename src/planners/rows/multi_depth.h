#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Multi-depth back-and-forth (MDB&F): parallel lines at spacing W in each depth region by itself,
/// along the region's own best direction (or `heading`), with one opening angle from the region's
/// mean depth; region after region by the nearest end. The ways between lines and regions stay in
/// the water, ping, and are not logged.
/// @throws UsageError for options out of range or bands that hold no part of the area.
[[nodiscard]] Plan plan_multi_depth(const PlanningGround& ground, const PlanOptions& options);

}  // namespace swathplan

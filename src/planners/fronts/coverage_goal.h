#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/water_raster.h"
#include "planners/plan.h"

namespace swathplan {

/// Logged coverage that a plan is to reach where none is asked for, per cent.
inline constexpr double kUsualGoal = 98.0;
/// The same where several soundings a cell are wanted, as S-44's annex has it for five.
inline constexpr double kUsualGoalSeveral = 95.0;

/// Per cent of the cells that plans for the fewest hours are to cover: the share that the options'
/// goal or the usual one asks for, of the cells that some place in safe water may see by the widest
/// fan over the depth there.
[[nodiscard]] double coverage_goal_pct(const WaterRaster& raster, const AreaQuery& safe_water,
                                       const PlanOptions& options);

}  // namespace swathplan

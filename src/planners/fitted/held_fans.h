#pragma once

#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/fronts/water_raster.h"
#include "planners/plan.h"

namespace swathplan {

/// Gives each line the fan and the speed that it keeps from end to end, as a sonar is set and a
/// boat is steered. Each side opens, in whole degrees, so far that all but a small share of the
/// line's metres inside the survey area have the angle that they ask for. Where `angles` is
/// Angles::ping fans stay as they are; those of waypoints beyond the area take the angle of the
/// nearest waypoint in it. With `opening_angle` every line has that fan. The speed, in steps of
/// 0.1 m/s, is the largest at which pings by the clock still lay the soundings wanted over the
/// line's deeper parts; no less than the least speed.
void hold_fans(std::vector<std::vector<Waypoint>>& lines, const WaterRaster& raster,
               const AreaQuery& survey_area, const PlanOptions& options);

}  // namespace swathplan

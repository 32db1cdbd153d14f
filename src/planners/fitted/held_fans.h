#pragma once

#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/fronts/water_raster.h"
#include "planners/plan.h"

namespace swathplan {

/// Gives each line the fan and the speed that it keeps, as a sonar is set and a boat is steered.
/// Each side opens, in whole degrees, so far that all but a small share of the line's metres inside
/// the survey area have the angle that they ask for. A line whose fan would lose more than
/// kSecondsOfChange worth of its soundings by that, since the depth changes along it, is sailed in
/// legs, each with a fan and a speed of its own and no shorter than the least line. Where `angles`
/// is Angles::ping fans stay as they are; those of waypoints beyond the area take the angle of the
/// nearest waypoint in it. With `opening_angle` every line has that fan. The speed, in steps of 0.1
/// m/s, is the largest at which pings by the clock still lay `edge_share` of the soundings wanted
/// at the swath's edge, over the leg's deeper parts; no less than the least speed. Under 1 the rest
/// is left to the neighbour, whose swath reaches into this one.
void hold_fans(std::vector<std::vector<Waypoint>>& lines, const WaterRaster& raster,
               const AreaQuery& survey_area, const PlanOptions& options, double edge_share = 1.0);

/// What it takes a crew to set another fan on the way, in seconds at survey speed.
inline constexpr double kSecondsOfChange = 60.0;

}  // namespace swathplan

#pragma once

#include <vector>

#include "coverage/standards/area_rate.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// What the options ask of a fan over level ground: the resolution's cells with so many soundings,
/// by the clock, at speeds from the least one to the vehicle's. A `stretch` above 1 lets beams and
/// pings stand so much farther apart than a cell while as many soundings fall on the ground.
[[nodiscard]] RateQuestion rate_question(const PlanOptions& options, double stretch = 1.0);

/// The least hours of the area (area_rate.h), by the depths of its cells, and what no fan reaches.
/// With a criterion: by its cells, soundings and cubes and the fan that it accepts at each depth,
/// twice where two lines must see each place, and less by the ground that may stay unseen between
/// lines where it asks for depths no farther apart than a distance.
[[nodiscard]] LeastHours hours_and_reach(const WaterRaster& raster, const PlanOptions& options);
/// The hours alone.
[[nodiscard]] double least_hours(const WaterRaster& raster, const PlanOptions& options);

/// The swath of every cell of the area that surveys it fastest, metres; 0 outside. Where no fan
/// serves, it is the widest whose beams stand no farther apart than a cell. `overlap`: the share of
/// it that neighbours have in common, [0, 1).
[[nodiscard]] std::vector<float> rate_width_field(const WaterRaster& raster,
                                                  const PlanOptions& options, double stretch,
                                                  double overlap);

}  // namespace swathplan

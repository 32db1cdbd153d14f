#pragma once

#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// Lines along the walls of an area, as a farmer ploughs the headland of a field by itself: where
/// there is no room to turn beyond the end of a line, lines would have to end short of the wall and
/// leave a strip there.
struct Headland {
  std::vector<SurveyCurve> lines;
  std::vector<char> inner;  ///< a flag a cell: of the area, and not swept by these lines
};

/// The stretches of the area's outline beyond which, within `room_m`, no safe water lies.
[[nodiscard]] std::vector<SurveyCurve> walls_without_room(const Area& survey_area,
                                                          const AreaQuery& water, double room_m,
                                                          double step_m);

struct HeadlandOptions {
  double from_wall = 0.5;  ///< swaths from the walls to the lines, > 0
  double step_m = 1.0;     ///< between the points that are smoothed, > 0
  int smooth_passes = 0;   ///< of a binomial filter
};

/// The headland along `walls`, for swaths of `width`.
[[nodiscard]] Headland headland_along(const std::vector<SurveyCurve>& walls,
                                      const WaterRaster& raster, const std::vector<float>& width,
                                      const HeadlandOptions& options = {});

}  // namespace swathplan

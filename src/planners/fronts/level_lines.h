#pragma once

#include "planners/fronts/eikonal.h"
#include "planners/fronts/survey_curve.h"

namespace swathplan {

/// The lines where u = `level`, with u linear between cell centres. Each line is as long as it can
/// be: it is closed, or ends where u is not known. A closed line ends at its first point. O(cells).
[[nodiscard]] std::vector<SurveyCurve> level_lines(const WaterRaster& raster,
                                                   const std::vector<float>& u, double level);

}  // namespace swathplan

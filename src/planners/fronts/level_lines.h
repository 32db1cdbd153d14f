#pragma once

#include "planners/fronts/eikonal.h"
#include "planners/fronts/survey_curve.h"

namespace swathplan {

/// The lines where u = `level`, linear between cell centres; each maximal chain once, closed ones
/// cut where they begin. Ends where u is not known. O(cells).
[[nodiscard]] std::vector<SurveyCurve> level_lines(const WaterRaster& raster,
                                                   const std::vector<float>& u, double level);

}  // namespace swathplan

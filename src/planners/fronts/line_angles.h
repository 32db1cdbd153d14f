#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

struct LineAnglesOptions {
  double overlap_m = 0.4;     ///< that a side reaches past the boundary to its neighbour, >= 0
  double widest_share = 1.0;  ///< of W that one side reaches at most
  /// Lines meet half-way in metres, not in swaths: for steps in the seafloor, where a line over the
  /// deep would reach up onto the shoal and spread its beams for it.
  bool by_distance = false;
};

/// Opens the fan along survey lines, each side by itself: to the farthest point that this line sees
/// from fewer of its swaths away than any other line does, plus the overlap; or to the area's edge
/// (a fan that reaches past an edge wastes beams); at most `widest_share` x W and what the sonar
/// can do. A point behind a shoal or under a wall is not seen, so the line on its other side
/// reaches for it. The angle of a side is the largest that any point up to its reach asks for.
/// Returns the waypoints of each line (sonar on, logged, numbered from `first_number`).
[[nodiscard]] std::vector<std::vector<Waypoint>> opened_lines(
    const std::vector<SurveyCurve>& lines, const WaterRaster& raster,
    const std::vector<float>& width, const AreaQuery& survey_area, const PlanOptions& options,
    const LineAnglesOptions& how, int first_number = 1);

/// A side is never narrower than this, so that a line along a wall still sees below itself.
inline constexpr double kLeastSideDeg = 3.0;

}  // namespace swathplan

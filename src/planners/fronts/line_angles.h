#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

struct LineAnglesOptions {
  double overlap_m = 0.4;      ///< how far a side reaches past the boundary to its neighbour, >= 0
  double overlap_share = 0.0;  ///< the same as a share of W, on top of it, >= 0
  double widest_share = 1.0;   ///< the largest share of W that one side may reach
  /// True: lines meet half-way in metres, not in swaths. This is for steps in the seafloor, where a
  /// line over the deep would else reach up onto the shoal and spread its beams too widely.
  bool by_distance = false;
};

/// Opens the fan along survey lines, each side by itself. A point of the seafloor belongs to the
/// line that sees it from the fewest of its own swaths away. A side reaches to the farthest point
/// of its line, plus the overlap. It stops at the area's edge, since beams past an edge are wasted.
/// It reaches no farther than `widest_share` x W and the sonar's limits. A line does not see a
/// point behind a shoal or under a wall, so the line on the other side reaches for it. The angle of
/// a side is the largest that any point within its reach asks for. Returns the waypoints of each
/// line (sonar on, logged, numbered from `first_number`).
[[nodiscard]] std::vector<std::vector<Waypoint>> opened_lines(
    const std::vector<SurveyCurve>& lines, const WaterRaster& raster,
    const std::vector<float>& width, const AreaQuery& survey_area, const PlanOptions& options,
    const LineAnglesOptions& how, int first_number = 1);

/// A side is never narrower than this, so that a line along a wall still sees below itself.
inline constexpr double kLeastSideDeg = 3.0;

}  // namespace swathplan

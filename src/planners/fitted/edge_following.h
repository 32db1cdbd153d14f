#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/swept_lines.h"
#include "planners/plan.h"

namespace swathplan {

struct EdgeFollowingOptions {
  double margin = 0.1;         ///< of its swath that a line shares with the one before it, [0, 0.4]
  double step_m = kCurveStep;  ///< between the points of a line, > 0
  int smooth_passes = 60;      ///< of a binomial filter over them
  /// How far ends are carried on straight, as a share of W, where lines may run there.
  double run_on = 0.0;
};

/// Survey lines edge to edge, as crews steer them today: the first lies half a swath off the wall;
/// each later one so that its near edge falls on the outer edge of the swath before it, less the
/// margin; until nothing is left that a line could sweep. Where the swept water's edge comes apart
/// (a basin, an island), each piece is followed. A strip too narrow for that gets a line nearer to
/// its edge. Curves as they come: each bend of an edge is handed on to the next line.
/// In the order in which they are laid; inside `lines_in`.
[[nodiscard]] std::vector<SurveyCurve> edge_following_lines(
    const SweptGround& ground, const AreaQuery& lines_in, const FieldWall& wall,
    const EdgeFollowingOptions& options = {});

/// Edge-following, today's best practice, as a baseline: such lines from the area's long walls, of
/// which the simulator picks the best (without a scene: the longest wall); fans, order and joins
/// as those of fitted lines. Margin: the options' `lines_margin`.
/// @throws InvalidInput where no line fits into the water; UsageError for options out of range.
[[nodiscard]] Plan plan_edge_following(const PlanningGround& ground, const PlanOptions& options);

}  // namespace swathplan

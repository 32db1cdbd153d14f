#pragma once

#include "mesh/plane/area_query.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/swept_lines.h"
#include "planners/plan.h"

namespace swathplan {

struct EdgeFollowingOptions {
  double margin = 0.1;         ///< share of a swath that overlaps the one before it, [0, 0.4]
  double step_m = kCurveStep;  ///< between the points of a line, > 0
  int smooth_passes = 60;      ///< of a binomial filter over them
  /// How far lines run on straight at their ends, as a share of W, where they may.
  double run_on = 0.0;
  double least_m = 0.0;  ///< no line is shorter; what it would have swept is left to others
};

/// Survey lines edge to edge, as crews steer them today. The first line lies half a swath off the
/// wall. The near edge of each later swath falls on the outer edge of the swath before it, less the
/// margin. This goes on until no line could sweep more. Where the edge of the swept water divides
/// (at a basin, an island), each piece is followed. A strip too narrow for that gets a line nearer
/// to its edge. Each bend of an edge passes on to the next line. Lines come in the order in which
/// they are laid, and lie inside `lines_in`.
[[nodiscard]] std::vector<SurveyCurve> edge_following_lines(
    const SweptGround& ground, const AreaQuery& lines_in, const FieldWall& wall,
    const EdgeFollowingOptions& options = {});

/// Edge-following, today's best practice, as a baseline. Lines start from the area's long walls.
/// The simulator picks the best wall; without a scene it is the longest one. Fans, order and joins
/// are as for fitted lines. The margin is the options' `lines_margin`.
/// @throws InvalidInput where no line fits into the water; UsageError for options out of range.
[[nodiscard]] Plan plan_edge_following(const Ground& ground, const PlanOptions& options);

}  // namespace swathplan

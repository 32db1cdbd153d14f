#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "planners/plan.h"
#include "planners/rows/line_order.h"
#include "planners/rows/route_builder.h"
#include "planners/rows/survey_lines.h"

namespace swathplan {

/// How parallel rows follow each other.
struct RowOrder {
  /// True: each row follows its neighbour. False: the order with the least estimated way in all,
  /// which skips rows where turns are wide.
  bool to_and_fro = true;
  /// Joins to be avoided, since no path was found for them: from the end of a line to the beginning
  /// of another.
  std::vector<std::pair<Vec2, Vec2>> avoided;
};

/// True where the turn into the next row is wider than a lane, the distance between rows. To and
/// fro would take bulbs then.
[[nodiscard]] bool rows_need_skips(const PlanOptions& options);

/// Puts lines in an order and turns each the way that it is sailed. Begins near `start`, if given.
[[nodiscard]] std::vector<SurveyLine> ordered(const std::vector<SurveyLine>& lines,
                                              const RowOrder& order, const JoinCost& cost,
                                              double turn_radius_m,
                                              const std::optional<Vec2>& start);

/// Builds the route to and fro. Where rows need skips, a few orders of least way are built as well.
/// Each of them avoids the joins that were infeasible in the routes before. The best route has the
/// fewest metres marked infeasible. Of equal ones the shortest is best, where a metre of line given
/// up for turns counts as two metres of way. A note tells if the best one is not to and fro.
[[nodiscard]] BuiltRoute shorter_order(const PlanOptions& options,
                                       const std::function<BuiltRoute(const RowOrder&)>& build);

}  // namespace swathplan

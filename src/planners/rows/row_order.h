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
  /// True: each row after its neighbour. False: the least estimated way in all; rows are skipped
  /// where turns ask for it.
  bool to_and_fro = true;
  /// Joins, from the end of a line to the beginning of another, to be avoided: none was found.
  std::vector<std::pair<Vec2, Vec2>> avoided;
};

/// True where the turn into the next row is wider than the rows are apart, so that to and fro takes
/// bulbs: rows are W apart.
[[nodiscard]] bool rows_need_skips(const PlanOptions& options);

/// Lines in an order, turned as they are sailed. Begins near `start`, if given.
[[nodiscard]] std::vector<SurveyLine> ordered(const std::vector<SurveyLine>& lines,
                                              const RowOrder& order, const JoinCost& cost,
                                              double turn_radius_m,
                                              const std::optional<Vec2>& start);

/// What `build` makes of to and fro, or where rows need skips the best of that and of a few orders
/// of least way, each avoiding the joins that the ones before found infeasible: the one with the
/// fewest metres marked infeasible, of those with as many the shortest, a metre of line given up
/// for turns counting as two of way. A note says if it is not to and fro.
[[nodiscard]] BuiltRoute shorter_order(const PlanOptions& options,
                                       const std::function<BuiltRoute(const RowOrder&)>& build);

}  // namespace swathplan

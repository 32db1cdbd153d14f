#pragma once

#include "planners/fronts/coverage_goal.h"
#include "planners/plan.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// Lines for the fewest hours: for a survey that is paid by time and judged by what its logged
/// lines cover. Each place is served by the swath with the largest area rate (area_rate.h).
/// Straight rows, field lines and edge-following lines are laid by it, over several overlaps and
/// directions. Lines run on beyond the survey area's edge as far as they still cover some of it.
/// Each keeps one fan and one speed. The simulator judges candidates by hours and logged coverage;
/// the best ones are filled in and judged in full. Picks the fewest hours that reach the goal;
/// without a goal that is kUsualGoal per cent of the cells. `ground` must hold its scene.
/// @throws InvalidInput where no line fits into the water; UsageError for options out of range.
[[nodiscard]] Plan plan_fewest_hours(const Ground& ground, const PlanOptions& options);

/// Lines of a search, before any gap is filled.
struct LaidLines {
  BuiltRoute built;
  std::string what;  ///< how they are laid
};
/// The lines that the same search finds best, at most so many, the best first; all are laid in
/// different ways. @throws as plan_fewest_hours().
[[nodiscard]] std::vector<LaidLines> lines_for_fewest_hours(const Ground& ground,
                                                            const PlanOptions& options,
                                                            std::size_t most);

}  // namespace swathplan

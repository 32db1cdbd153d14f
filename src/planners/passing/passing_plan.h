#pragma once

#include "coverage/judging/judged_survey.h"
#include "planners/plan.h"

namespace swathplan {

/// The fewest hours that are predicted to pass a criterion. Lines for the fewest hours are laid by
/// the swaths and speeds that the criterion lets serve (area_rate.h, criterion_fan.h), on small
/// sites several sets of them, then judged by its own rows on its own grids. Where coverage or
/// features fail, passes are added from which the sonar sees the failing cells; where the density
/// fails, lines are sailed slower. Lines, passes and ends of lines that can be spared then are left
/// out, the longest first. This is done again until all rules pass and nothing helps. The plan is
/// held against a boat that is off its line by kAsideM, and off its course by kOffCourseDeg, or by
/// three times the deviations of `options.noise` where they are more (shown_cells.h), so that it
/// passes on an ordinary day too; where no pass holds so much, against less. For criteria that ask
/// for depths no farther apart than a distance the lines lie as far apart (sparse_lines.h). The
/// notes say what was done, for how much ground no pass is laid since it is out of reach and, where
/// cells still fail, how many and where. `options.sonar` is what may be counted on (narrowed_to());
/// `judge` and its ground must outlive the call. @throws as plan_fewest_hours().
[[nodiscard]] Plan plan_to_pass(const SurveyJudge& judge, const PlanOptions& options);

/// Three times the deviations of calm tracking.
inline constexpr double kAsideM = 0.9;
inline constexpr double kOffCourseDeg = 6.0;

}  // namespace swathplan

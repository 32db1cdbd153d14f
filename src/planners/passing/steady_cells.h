#pragma once

#include <vector>

#include "coverage/judging/judged_survey.h"
#include "planners/passing/gap_passes.h"
#include "planners/plan.h"

namespace swathplan {

/// The criterion's cells as a boat leaves them that is not steady. Lines are sailed twice: off to
/// starboard and clockwise of their course, and off to the other side. What a line shows of a cell
/// is the less of both, since the boat may be anywhere between; what several lines show adds up. So
/// what is covered here stays so while the boat wanders within these bounds. Pings are thinned to
/// about half a cell; soundings are counted as if all were there. Empty for a route without logged
/// lines.
[[nodiscard]] std::vector<JudgedGrid> steady_cells(const SurveyJudge& judge, const Route& route,
                                                   const PlanOptions& options,
                                                   const Unsteadiness& unsteady);

}  // namespace swathplan

#pragma once

#include <optional>

#include "coverage/judging/judged_survey.h"
#include "planners/fitted/line_workshop.h"

namespace swathplan {

/// A plan, and what the criterion says of it.
struct SparsePlan {
  BuiltRoute built;
  Verdict verdict;
  double spacing_share = 1.0;  ///< of the distance that depths may lie apart
};

/// Straight lines for a criterion that asks for depths no farther apart than a distance
/// (GapRule::spread): a swath and most of that distance lie between them. Of several directions,
/// and of ever closer lines, the fewest hours that are predicted to pass; where none are, the
/// closest lines tried. Empty if no line fits.
[[nodiscard]] std::optional<SparsePlan> sparse_lines(const SurveyJudge& judge, LineWorkshop& shop);

}  // namespace swathplan

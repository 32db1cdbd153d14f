#pragma once

#include <nlohmann/json.hpp>

#include "coverage/judging/judged_survey.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// What a criterion says of a survey: verdict, rules, where they fail (file coordinates), and the
/// histogram of TVU by its limit.
[[nodiscard]] nlohmann::ordered_json verdict_json(const JudgedSurvey& survey, const Frame& frame);

}  // namespace swathplan

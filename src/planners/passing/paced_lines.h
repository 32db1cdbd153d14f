#pragma once

#include "coverage/judging/judged_survey.h"
#include "planners/plan.h"

namespace swathplan {

/// Slows logged legs to the speeds at which pings by the clock stand no farther apart than the
/// criterion lets them (its cells and cubes), over the leg's deepest water; and to `pace` of the
/// speed that they have, (0, 1]. In steps of 0.1 m/s, no slower than the least speed.
void pace_lines(Route& route, const SurveyJudge& judge, const PlanOptions& options, double pace);

/// Opens the fans of survey lines as wide as the criterion accepts over their shoalest water: where
/// each place must be seen by two lines, fans reach beyond the neighbouring line.
void open_for_two_lines(Route& route, const SurveyJudge& judge, const PlanOptions& options);

/// Seconds under way.
[[nodiscard]] double sailing_s(const Route& route);

}  // namespace swathplan

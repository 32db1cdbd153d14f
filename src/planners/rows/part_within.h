#pragma once

#include <optional>

#include "coverage/route/route.h"
#include "planners/pareto.h"

namespace swathplan {

/// The part of a route that has the most line within the goal's length or time: lines that follow
/// each other, with the joins between them as they are; where not one fits, as much of the longest
/// as does. Lines are numbered anew, from 1. Empty where the goal sets neither, and where it holds
/// no line of `least_line_m` metres.
[[nodiscard]] std::optional<Route> part_within(const Route& route, const PlanGoal& goal,
                                               double least_line_m);

}  // namespace swathplan

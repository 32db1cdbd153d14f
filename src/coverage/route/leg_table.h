#pragma once

#include "coverage/route/route.h"

namespace swathplan {

/// The waypoints of a route from which on other things hold than before: where a leg begins or the
/// speed changes; and its end. Written beside exports, since their formats hold no angles and, of
/// logging and speeds, not all. Fans that change within a leg are lost.
[[nodiscard]] Route leg_table(const Route& route);

/// The route with the kinds, numbers, logging, fans and speeds that a leg table of the same plan
/// holds. Rows are looked for in their order: a row is met at the first waypoint within
/// kLegTableM of it. Each logged row must be met; others, such as turns that a format leaves out,
/// may be missing. What lies before the first row that is met is not logged.
/// @throws InvalidInput for a logged row that no waypoint meets.
[[nodiscard]] Route with_leg_table(const Route& route, const Route& table);

/// Formats round to centimetres.
inline constexpr double kLegTableM = 0.05;

}  // namespace swathplan

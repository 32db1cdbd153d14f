#pragma once

#include <cstddef>
#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// Path that must not be sailed: over land, metres.
[[nodiscard]] double over_land_m(const std::vector<Vec2>& points, const AreaQuery& land);

/// Marks each leg that leads over land infeasible; a touch of kTouchM at its shore does not count.
/// Returns how many legs were not marked before.
std::size_t mark_over_land(Route& route, const Area& land);

inline constexpr double kTouchM = 0.01;

}  // namespace swathplan

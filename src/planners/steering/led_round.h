#pragma once

#include <optional>
#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// What of a survey line cannot be sailed.
struct CutLine {
  std::optional<int> line;  ///< its number
  double left_out_m = 0.0;
};

/// A route that keeps out of an area.
struct LedRound {
  Route route;
  std::vector<CutLine> cut;  ///< in sailing order
};

/// Cuts survey lines `room_m` before the area, and leads the transits between what is left of them
/// round it, through `water` where that has a way. Parts of under a metre are not sailed. Transits
/// that the area does not touch are straight, as are those that no way was found for. If no
/// line is left, the route is empty.
/// `water`: the area itself need not be taken off it.
[[nodiscard]] LedRound led_round(const Route& route, const Area& area, const Area& water,
                                 double room_m);

}  // namespace swathplan

#pragma once

#include <vector>

#include "coverage/route/route.h"

namespace swathplan::internal {

/// A leg of a route as the page draws, lists and plays it.
struct SailedLeg {
  Leg leg;                      ///< in the route
  std::vector<Vec2> points;     ///< thinned
  std::vector<double> seconds;  ///< from the start of the route, at each of the points
  double length_m = 0.0;
};

/// All legs of a route, in order. Points that lie within `tolerance_m` of the remaining line are
/// left out; ends of legs stay. The tolerance doubles, three times at most, while more than
/// `most_points` are left.
[[nodiscard]] std::vector<SailedLeg> sailed_legs(const Route& route, double tolerance_m,
                                                 std::size_t most_points);

}  // namespace swathplan::internal

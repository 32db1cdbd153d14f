#pragma once

#include <vector>

#include "planners/plan.h"

namespace swathplan {

/// What lines are to run beside, local metres.
struct GivenShapes {
  std::vector<std::vector<Vec2>> lines;  ///< of at least two points each
  std::vector<Vec2> points;
  Area polygons;
};

struct BesideOptions {
  int to_each_side = 1;     ///< lines, >= 1
  double spacing_m = 20.0;  ///< between a line and the next, > 0
};

/// Lines that run beside given shapes: along a line itself and `to_each_side` times on either side
/// of it; around a point or polygon that many times, closed. All are `spacing_m` apart, keep to the
/// survey area and the safe water, and have joins that the vehicle can steer. Each has one fan,
/// which reaches as far as the lines beside it, if the sonar does.
/// The plan has no waypoints where no piece as long as the options' least line lies in the water.
[[nodiscard]] Plan plan_beside(const GivenShapes& shapes, const BesideOptions& how,
                               const Ground& ground, const PlanOptions& options);

/// The paths alone, before they are cut to the water: sides of lines run the way that these do.
[[nodiscard]] std::vector<std::vector<Vec2>> paths_beside(const GivenShapes& shapes,
                                                          const BesideOptions& how);

/// @throws UsageError that names the option, its value and the rule.
void check(const BesideOptions& how);

}  // namespace swathplan

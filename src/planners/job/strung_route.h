#pragma once

#include <optional>
#include <vector>

#include "planners/job/job_line.h"
#include "planners/plan.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// Where a boat lies, and on which course; empty: on any.
struct Berth {
  Vec2 place = Vec2::Zero();
  std::optional<Vec2> course = std::nullopt;
};

/// Strings lines to a route in their order: joins that they have stay, the others are found through
/// the water (RouteBuilder). Lines that meet on one course become one. With a berth the route
/// begins and ends there; both ways are transits with the sonar off. A berth's course is kept where
/// the boat finds room to turn from it. No lines give an empty route.
[[nodiscard]] BuiltRoute strung(const std::vector<JobLine>& lines,
                                const std::optional<Berth>& berth, const Ground& ground,
                                const PlanOptions& options, const Connector& connector);

/// The place where a route ends, and its last course.
[[nodiscard]] Berth end_of(const Route& route);

/// Routes one after the other, each of which begins where the one before ends.
[[nodiscard]] Route one_after_the_other(const std::vector<const Route*>& routes);

/// Metres of a route that are marked infeasible.
[[nodiscard]] double infeasible_m(const Route& route);

}  // namespace swathplan

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/plan.h"
#include "planners/rows/line_order.h"
#include "planners/steering/water_path.h"

namespace swathplan {

/// Estimates the seconds of ways between lines, and between lines and the berth.
class JobWays {
 public:
  JobWays(const Ground& ground, const PlanOptions& options);

  /// From a place and course to another.
  [[nodiscard]] double join_s(const Vec2& a, const Vec2& course_a, const Vec2& b,
                              const Vec2& course_b) const;
  /// Between a place that is left or reached on any course, such as a berth, and the end of a line
  /// with the course there that leads on from the way.
  [[nodiscard]] double free_s(const Vec2& place, const Vec2& line_end, const Vec2& course) const;
  /// Whether both lie in the same water.
  [[nodiscard]] bool joined(const Vec2& a, const Vec2& b) const;

 private:
  [[nodiscard]] double seconds(double metres) const;
  [[nodiscard]] double way_m(const Vec2& a, const Vec2& b) const;

  JoinCost cost_;
  Vehicle vehicle_;
  double turn_reach_;
  Area water_;
  std::vector<AreaQuery> waters_;             // each apart from the others
  mutable std::unique_ptr<WaterPath> exact_;  // of passages that the estimate does not see
};

}  // namespace swathplan

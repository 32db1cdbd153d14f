#include "planners/job/job_ways.h"

#include <algorithm>

#include "coverage/route/route_figures.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

JobWays::JobWays(const Ground& ground, const PlanOptions& options)
    : cost_(ground.water, options.vehicle.turn_radius_m),
      vehicle_(options.vehicle),
      turn_reach_(turn_reach_m(options)),
      water_(ground.water) {
  for (const Polygon& polygon : water_) waters_.emplace_back(Area{polygon});
}

double JobWays::seconds(double metres) const {
  return metres / (metres <= turn_reach_ ? vehicle_.turn_speed_mps : vehicle_.transit_speed_mps);
}

double JobWays::join_s(const Vec2& a, const Vec2& course_a, const Vec2& b,
                       const Vec2& course_b) const {
  return seconds(cost_(a, course_a, b, course_b));
}

double JobWays::way_m(const Vec2& a, const Vec2& b) const {
  const double estimate = cost_.way(a, b);
  if (estimate < JoinCost::kNoWay || !joined(a, b)) return estimate;
  if (!exact_) exact_ = std::make_unique<WaterPath>(water_);
  const auto way = exact_->find(a, b);
  if (!way) return estimate;
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < way->size(); ++i) sum += ((*way)[i + 1] - (*way)[i]).norm();
  return sum;
}

double JobWays::free_s(const Vec2& place, const Vec2& line_end, const Vec2& course) const {
  const Vec2 apart = line_end - place;
  if (apart.norm() < kCoincident) return 0.0;
  const double way = way_m(place, line_end);
  // The berth may be left or reached on any course, so only the line's own asks for a turn.
  const Vec2 chord = apart.normalized();
  return (way + cost_.turning(place, chord, line_end, course, way)) / vehicle_.transit_speed_mps;
}

bool JobWays::joined(const Vec2& a, const Vec2& b) const {
  return std::any_of(waters_.begin(), waters_.end(), [&](const AreaQuery& water) {
    return water.contains(a) && water.contains(b);
  });
}

}  // namespace swathplan

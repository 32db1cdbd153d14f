#include "coverage/route/over_land.h"

namespace swathplan {

double over_land_m(const std::vector<Vec2>& points, const AreaQuery& land) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    sum += land.inside_length(points[i], points[i + 1]);
  }
  return sum;
}

std::size_t mark_over_land(Route& route, const Area& land) {
  if (land.empty()) return 0;
  const AreaQuery query(land);
  std::size_t marked = 0;
  for (const Leg& leg : legs(route)) {
    if (!route.waypoints[leg.first].feasible) continue;
    double over = 0.0;
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      over += query.inside_length(route.waypoints[i].position, route.waypoints[i + 1].position);
    }
    if (over <= kTouchM) continue;
    for (std::size_t i = leg.first; i < leg.last; ++i) route.waypoints[i].feasible = false;
    ++marked;
  }
  return marked;
}

}  // namespace swathplan

#include "io/report/sailed_legs_internal.h"
#include "mesh/plane/path_thinning.h"

namespace swathplan::internal {
namespace {

std::vector<SailedLeg> thinned_legs(const Route& route, double tolerance_m) {
  std::vector<SailedLeg> out;
  double now = 0.0;
  for (const Leg& leg : legs(route)) {
    std::vector<Vec2> path{route.waypoints[leg.first].position};
    std::vector<double> seconds{now};
    SailedLeg& sailed = out.emplace_back();
    sailed.leg = leg;
    for (std::size_t i = leg.first; i < leg.last; ++i) {
      const Vec2& next = route.waypoints[i + 1].position;
      const double step = (next - path.back()).norm();
      sailed.length_m += step;
      now += step / route.waypoints[i].speed_mps;
      path.push_back(next);
      seconds.push_back(now);
    }
    for (const std::size_t k : thin_path(path, {}, tolerance_m).kept) {
      sailed.points.push_back(path[k]);
      sailed.seconds.push_back(seconds[k]);
    }
  }
  return out;
}

std::size_t points_of(const std::vector<SailedLeg>& list) {
  std::size_t sum = 0;
  for (const SailedLeg& leg : list) sum += leg.points.size();
  return sum;
}

}  // namespace

std::vector<SailedLeg> sailed_legs(const Route& route, double tolerance_m,
                                   std::size_t most_points) {
  std::vector<SailedLeg> out = thinned_legs(route, tolerance_m);
  for (int i = 0; i < 3 && points_of(out) > most_points; ++i) {
    tolerance_m *= 2.0;
    out = thinned_legs(route, tolerance_m);
  }
  return out;
}

}  // namespace swathplan::internal

#include "coverage/thin_route.h"

#include "mesh/path_thinning.h"

namespace swathplan {

ThinnedRoute thin_route(const Route& route, double tolerance_m) {
  const auto& w = route.waypoints;
  std::vector<Vec2> path;
  std::vector<bool> keep(w.size(), false);
  for (std::size_t i = 0; i < w.size(); ++i) {
    path.push_back(w[i].position);
    keep[i] = i > 0 && w[i].speed_mps != w[i - 1].speed_mps;
  }
  for (const Leg& leg : legs(route)) keep[leg.first] = true;
  const ThinnedPath thinned = thin_path(path, keep, tolerance_m);
  ThinnedRoute result{{}, thinned.largest_distance_m};
  for (const std::size_t i : thinned.kept) result.route.waypoints.push_back(w[i]);
  return result;
}

}  // namespace swathplan

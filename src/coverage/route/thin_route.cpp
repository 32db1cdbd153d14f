#include "coverage/route/thin_route.h"

#include "mesh/plane/path_thinning.h"

namespace swathplan {
namespace {

constexpr double kRoundingM = 0.001;  // corners of areas are rounded to a lattice

double outside_m(const Vec2& a, const Vec2& b, const AreaQuery& water) {
  return (b - a).norm() - water.inside_length(a, b);
}

/// Allows straights that leave the water no longer than the path does.
StraightRule stays_in(const AreaQuery& water, const std::vector<Vec2>& path) {
  std::vector<double> outside(path.size(), 0.0);  // up to each point
  for (std::size_t i = 1; i < path.size(); ++i) {
    outside[i] = outside[i - 1] + outside_m(path[i - 1], path[i], water);
  }
  return [&water, &path, outside](std::size_t first, std::size_t last) {
    return outside_m(path[first], path[last], water) <= outside[last] - outside[first] + kRoundingM;
  };
}

}  // namespace

ThinnedRoute thin_route(const Route& route, double tolerance_m, const AreaQuery* water) {
  const auto& w = route.waypoints;
  std::vector<Vec2> path;
  std::vector<bool> keep(w.size(), false);
  for (std::size_t i = 0; i < w.size(); ++i) {
    path.push_back(w[i].position);
    keep[i] = i > 0 && w[i].speed_mps != w[i - 1].speed_mps;
  }
  for (const Leg& leg : legs(route)) keep[leg.first] = true;
  const ThinnedPath thinned = thin_path(path, keep, tolerance_m,
                                        water != nullptr ? stays_in(*water, path) : StraightRule());
  ThinnedRoute result{{}, thinned.largest_distance_m};
  for (const std::size_t i : thinned.kept) result.route.waypoints.push_back(w[i]);
  return result;
}

}  // namespace swathplan

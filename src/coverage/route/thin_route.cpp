#include "coverage/route/thin_route.h"

#include <algorithm>
#include <cmath>

#include "coverage/route/bends.h"
#include "mesh/base/angle.h"
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

/// Keeps the points beside those that thinning made corners between long straights, so that a short
/// curve stays one. False if there is none.
bool keep_curves(const std::vector<Vec2>& path, const std::vector<std::size_t>& kept,
                 std::vector<bool>& keep) {
  bool changed = false;
  const auto keep_one = [&](std::size_t i, std::size_t beside) {
    if (i == beside || keep[i]) return;
    keep[i] = true;
    changed = true;
  };
  for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
    const std::size_t i = kept[k];
    const CourseChange change = course_change(path[kept[k - 1]], path[i], path[kept[k + 1]]);
    if (std::abs(change.angle_rad) <= Angle::degrees(kCornerDeg).rad()) continue;
    if (std::min(change.before_m, change.after_m) <= kLongestChordM) continue;
    keep_one(i - 1, kept[k - 1]);
    keep_one(i + 1, kept[k + 1]);
  }
  return changed;
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
  const StraightRule rule = water != nullptr ? stays_in(*water, path) : StraightRule();
  ThinnedPath thinned = thin_path(path, keep, tolerance_m, rule);
  while (keep_curves(path, thinned.kept, keep)) {
    thinned = thin_path(path, keep, tolerance_m, rule);
  }
  ThinnedRoute result{{}, thinned.largest_distance_m};
  for (const std::size_t i : thinned.kept) result.route.waypoints.push_back(w[i]);
  return result;
}

}  // namespace swathplan

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan::test {

/// Lines 20 m apart, 100 m long and joined by half circles, with a waypoint each 0.5 m; numbered
/// from 1, sailed at 2 m/s, the turns at 1.5 m/s.
inline Route lawnmower(int lines) {
  Route route;
  const auto add = [&](const Vec2& p, LegKind kind, int line) {
    const bool on = kind == LegKind::line;
    const FanAngles fan{Angle::degrees(60), Angle::degrees(60)};
    route.waypoints.push_back({.position = p,
                               .kind = kind,
                               .log = on,
                               .line = on ? std::optional<int>(line) : std::nullopt,
                               .fan = on ? std::optional<FanAngles>(fan) : std::nullopt,
                               .speed_mps = on ? 2.0 : 1.5,
                               .region = std::nullopt});
  };
  for (int line = 1; line <= lines; ++line) {
    const bool up = line % 2 == 1;
    const double x = 20.0 * line;
    for (int i = 0; i < 200; ++i) add(Vec2(x, up ? 0.5 * i : 100.0 - 0.5 * i), LegKind::line, line);
    const double end = up ? 100.0 : 0.0;
    if (line == lines) {
      add(Vec2(x, end), LegKind::end, line);
      break;
    }
    for (int i = 0; i < 60; ++i) {
      const double a = std::numbers::pi * i / 60.0;
      add(Vec2(x + 10.0 - 10.0 * std::cos(a), end + (up ? 10.0 : -10.0) * std::sin(a)),
          LegKind::turn, line);
    }
  }
  return route;
}

inline double distance_to_path(const Vec2& p, const std::vector<Vec2>& path) {
  double nearest = (p - path.front()).norm();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const double t = std::clamp((p - path[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - path[i - 1] - t * along).norm());
  }
  return nearest;
}

/// The largest distance of a waypoint of the route to a path.
inline double largest_distance(const Route& route, const std::vector<Vec2>& path) {
  double largest = 0.0;
  for (const Waypoint& w : route.waypoints) {
    largest = std::max(largest, distance_to_path(w.position, path));
  }
  return largest;
}

}  // namespace swathplan::test

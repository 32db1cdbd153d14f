#include "io/report/display_path_internal.h"
#include "mesh/plane/path_thinning.h"

namespace swathplan::internal {

std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m) {
  std::vector<Vec2> out;
  for (const std::size_t i : thin_path(line, {}, tolerance_m).kept) out.push_back(line[i]);
  return out;
}

std::vector<DisplayPath> display_path(const Route& route, double tolerance_m) {
  std::vector<DisplayPath> out;
  std::vector<Vec2> piece;
  const auto flush = [&] {
    if (piece.size() < 2) return;
    const std::vector<Vec2> part = simplified(piece, tolerance_m);
    auto& points = out.back().points;
    points.insert(points.end(), part.begin() + (points.empty() ? 0 : 1), part.end());
    piece = {piece.back()};
  };
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    const bool sonar = w.fan.has_value();
    if (out.empty() || out.back().kind != w.kind || out.back().log != w.log ||
        out.back().sonar != sonar) {
      flush();
      out.push_back({.kind = w.kind, .log = w.log, .sonar = sonar, .points = {}});
      piece = {w.position};
    }
    piece.push_back(route.waypoints[i + 1].position);
  }
  flush();
  return out;
}

}  // namespace swathplan::internal

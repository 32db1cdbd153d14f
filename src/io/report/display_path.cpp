#include <algorithm>

#include "io/report/display_path_internal.h"

namespace swathplan::internal {
namespace {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

}  // namespace

std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m) {
  if (line.size() < 3) return line;
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance_m;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_segment(line[i], line[first], line[last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) out.push_back(line[i]);
  }
  return out;
}

std::vector<DisplayPath> display_path(const Route& route, double tolerance_m) {
  // Douglas-Peucker is quadratic on lines that coil, so long stretches are taken in pieces.
  constexpr std::size_t kPiece = 2000;
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
    if (piece.size() > kPiece) flush();
  }
  flush();
  return out;
}

}  // namespace swathplan::internal

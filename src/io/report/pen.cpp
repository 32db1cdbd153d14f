#include <cmath>

#include "io/report/pen_internal.h"
#include "mesh/plane/path_thinning.h"

namespace swathplan::internal {

nlohmann::ordered_json Pen::line(const std::vector<Vec2>& points) const {
  auto out = nlohmann::ordered_json::array();
  long x = 0, y = 0;
  for (const Vec2& p : points) {
    const Vec2 relative = (p - box_.min) * 100.0;
    const long px = std::lround(relative.x()), py = std::lround(relative.y());
    out.push_back(px - x);
    out.push_back(py - y);
    x = px;
    y = py;
  }
  return out;
}

nlohmann::ordered_json Pen::rings(const Area& area, double tolerance_m) const {
  auto out = nlohmann::ordered_json::array();
  const auto add = [&](const Ring& points, bool always) {
    Box2 box;
    for (const Vec2& p : points) box.extend(p);
    if (points.empty() || (!always && box.size().maxCoeff() <= tolerance_m)) return;
    out.push_back(ring(points, tolerance_m));
  };
  for (const Polygon& polygon : area) {
    add(polygon.outer, true);
    for (const Ring& hole : polygon.holes) add(hole, false);
  }
  return out;
}

nlohmann::ordered_json Pen::edges(const std::vector<std::pair<Vec2, Vec2>>& list) const {
  auto out = nlohmann::ordered_json::array();
  for (const auto& [a, b] : list) out.push_back(line({a, b}));
  return out;
}

nlohmann::ordered_json Pen::box(const Box2& b) const {
  const Vec2 low = (b.min - box_.min) * 100.0, high = (b.max - box_.min) * 100.0;
  return {std::lround(low.x()), std::lround(low.y()), std::lround(high.x()), std::lround(high.y())};
}

nlohmann::ordered_json Pen::ring(const Ring& points, double tolerance_m) const {
  std::vector<Vec2> closed(points.begin(), points.end());
  closed.push_back(points.front());
  return line(simplified(closed, tolerance_m));
}

std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance_m) {
  std::vector<Vec2> out;
  for (const std::size_t i : thin_path(line, {}, tolerance_m).kept) out.push_back(line[i]);
  return out;
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

}  // namespace swathplan::internal

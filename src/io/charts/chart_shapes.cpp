#include <algorithm>

#include "io/charts/chart_shapes_internal.h"

namespace swathplan {
namespace {

std::vector<Vec2> chart_positions(const OGRSimpleCurve& line) {
  std::vector<Vec2> positions;
  for (int i = 0; i < line.getNumPoints(); ++i) positions.emplace_back(line.getX(i), line.getY(i));
  return positions;
}

bool all_finite(const std::vector<Vec2>& positions) {
  return std::all_of(positions.begin(), positions.end(),
                     [](const Vec2& p) { return p.allFinite(); });
}

void take_polygon(const OGRPolygon& polygon, ChartShapes& shapes) {
  std::vector<Ring> rings;
  for (const OGRLinearRing* line : polygon) {
    Ring ring = chart_positions(*line);
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) {
      if (rings.empty()) return;  // an outline that is no area has no holes either
      continue;
    }
    if (!all_finite(ring)) return;
    rings.push_back(std::move(ring));
  }
  if (!rings.empty()) shapes.polygons.push_back(std::move(rings));
}

void take(const OGRGeometry& geometry, ChartShapes& shapes) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (geometry.IsEmpty() != 0) return;
  if (type == wkbPolygon) {
    take_polygon(*geometry.toPolygon(), shapes);
  } else if (type == wkbLineString) {
    std::vector<Vec2> line = chart_positions(*geometry.toLineString());
    if (all_finite(line)) shapes.lines.push_back(std::move(line));
  } else if (type == wkbPoint) {
    const OGRPoint& p = *geometry.toPoint();
    const Vec3 place(p.getX(), p.getY(), p.Is3D() != 0 ? p.getZ() : 0.0);
    if (place.allFinite()) shapes.points.push_back(place);
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) take(*part, shapes);
  }
}

}  // namespace

ChartShapes shapes_of(const OGRGeometry* geometry) {
  ChartShapes shapes;
  if (geometry == nullptr) return shapes;
  // Arcs become short chords; flat geometries come back as they are.
  const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
  if (straight) take(*straight, shapes);
  return shapes;
}

}  // namespace swathplan

#include <cmath>
#include <memory>
#include <numbers>

#include "io/charts/hazard_shapes_internal.h"

namespace swathplan {
namespace {

constexpr int kQuarterChords = 12;  ///< of a quarter circle around points and lines
/// Arcs are chords, which lie up to 2 cm inside (polygons.h), and corners are rounded.
constexpr double kChordRoom = 0.03;

std::unique_ptr<OGRGeometry> line_of(const std::vector<Vec2>& line) {
  if (line.size() == 1) return std::make_unique<OGRPoint>(line.front().x(), line.front().y());
  auto path = std::make_unique<OGRLineString>();
  for (const Vec2& p : line) path->addPoint(p.x(), p.y());
  return path;
}

void add_around(const std::vector<Vec2>& line, double buffer_m, Area& all) {
  const double chord = std::cos(std::numbers::pi / (4.0 * kQuarterChords));
  const std::unique_ptr<OGRGeometry> buffer(
      line_of(line)->Buffer((buffer_m + kLattice) / chord, kQuarterChords));
  if (!buffer) return;
  for (const auto& rings : shapes_of(buffer.get()).polygons) {
    all = unite(all, from_rings(rings, false));
  }
}

/// The part of the ring on one side of a line along an axis: where `sign * place[axis]` is at most
/// `sign * limit` (Sutherland and Hodgman).
Ring cut_ring(const Ring& ring, int axis, double sign, double limit) {
  Ring part;
  const auto inside = [&](const Vec2& p) { return sign * p[axis] <= sign * limit; };
  for (std::size_t k = 0, before = ring.size() - 1; k < ring.size(); before = k++) {
    const Vec2& a = ring[before];
    const Vec2& b = ring[k];
    if (inside(a) != inside(b)) {
      Vec2 cut = a + (b - a) * ((limit - a[axis]) / (b[axis] - a[axis]));
      cut[axis] = limit;
      part.push_back(cut);
    }
    if (inside(b)) part.push_back(b);
  }
  return part;
}

/// Parts of a ring that fall apart stay joined along the box's sides, which has no area. Clipper
/// would do the same to a coast of 60,000 corners in seconds.
Ring clipped_ring(const Ring& ring, const Box2& box) {
  Ring part = ring;
  for (int axis = 0; axis < 2 && !part.empty(); ++axis) {
    part = cut_ring(part, axis, 1.0, box.max[axis]);
    if (!part.empty()) part = cut_ring(part, axis, -1.0, box.min[axis]);
  }
  return part;
}

}  // namespace

Area area_around(const ChartShapes& shapes, double buffer_m) {
  Area all;
  for (const auto& rings : shapes.polygons) all = unite(all, from_rings(rings, false));
  if (!(buffer_m > 0.0)) return all;
  if (!all.empty()) all = offset(all, buffer_m + kChordRoom);
  for (const auto& line : shapes.lines) add_around(line, buffer_m, all);
  for (const Vec3& point : shapes.points) add_around({point.head<2>()}, buffer_m, all);
  return all;
}

Box2 extent(const ChartShapes& shapes) {
  Box2 box;
  for (const auto& rings : shapes.polygons) {
    for (const Vec2& p : rings.front()) box.extend(p);
  }
  for (const auto& line : shapes.lines) {
    for (const Vec2& p : line) box.extend(p);
  }
  for (const Vec3& p : shapes.points) box.extend(p.head<2>());
  return box;
}

void clip_polygons(ChartShapes& shapes, const Box2& box) {
  std::vector<std::vector<Ring>> kept;
  for (const auto& rings : shapes.polygons) {
    std::vector<Ring> parts;
    for (const Ring& ring : rings) {
      Ring part = clipped_ring(ring, box);
      if (part.size() >= 3) parts.push_back(std::move(part));
    }
    if (!parts.empty()) kept.push_back(std::move(parts));
  }
  shapes.polygons = std::move(kept);
}

}  // namespace swathplan

#include "mesh/plane/polygons.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <polyclipping/clipper.hpp>

#include "mesh/plane/segments.h"
#include "mesh/plane/unite_in_halves_internal.h"

namespace swathplan {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Round corners are approximated to this far, metres.
constexpr double kArcTolerance = 0.02;

IntPoint to_lattice(const Vec2& p) {
  return {static_cast<cInt>(std::llround(p.x() / kLattice)),
          static_cast<cInt>(std::llround(p.y() / kLattice))};
}

Path to_path(const Ring& ring) {
  Path path;
  path.reserve(ring.size());
  for (const Vec2& p : ring) path.push_back(to_lattice(p));
  return path;
}

Ring to_ring(const Path& path) {
  Ring ring;
  ring.reserve(path.size());
  for (const IntPoint& p : path) {
    ring.emplace_back(static_cast<double>(p.X) * kLattice, static_cast<double>(p.Y) * kLattice);
  }
  return ring;
}

Paths to_paths(const Area& area) {
  Paths paths;
  for (const Polygon& polygon : area) {
    paths.push_back(to_path(polygon.outer));
    for (const Ring& hole : polygon.holes) paths.push_back(to_path(hole));
  }
  return paths;
}

/// Polygons from Clipper's tree of outer rings and holes. The largest comes first, so that the
/// order does not depend on how Clipper swept.
Area to_area(const ClipperLib::PolyTree& tree) {
  Area area;
  std::function<void(const ClipperLib::PolyNode&)> visit = [&](const ClipperLib::PolyNode& node) {
    for (const ClipperLib::PolyNode* outer : node.Childs) {
      Polygon polygon{to_ring(outer->Contour), {}};
      if (signed_area(polygon.outer) < 0.0)
        std::reverse(polygon.outer.begin(), polygon.outer.end());
      for (const ClipperLib::PolyNode* hole : outer->Childs) {
        Ring ring = to_ring(hole->Contour);
        if (signed_area(ring) > 0.0) std::reverse(ring.begin(), ring.end());
        polygon.holes.push_back(std::move(ring));
        visit(*hole);
      }
      area.push_back(std::move(polygon));
    }
  };
  visit(tree);
  std::stable_sort(area.begin(), area.end(),
                   [](const Polygon& a, const Polygon& b) { return area_m2({a}) > area_m2({b}); });
  return area;
}

Area boolean(const Area& a, const Area& b, ClipperLib::ClipType type) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(to_paths(a), ClipperLib::ptSubject, true);
  clipper.AddPaths(to_paths(b), ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(type, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return to_area(tree);
}

template <class Visit>
void each_edge(const Area& area, Visit&& visit) {
  const auto ring_edges = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) visit(ring[j], ring[i]);
  };
  for (const Polygon& polygon : area) {
    if (!polygon.outer.empty()) ring_edges(polygon.outer);
    for (const Ring& hole : polygon.holes) {
      if (!hole.empty()) ring_edges(hole);
    }
  }
}

}  // namespace

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    // Relative to the first point, so that large coordinates do not cancel.
    const Vec2 a = ring[j] - ring[0];
    const Vec2 b = ring[i] - ring[0];
    twice += cross(a, b);
  }
  return 0.5 * twice;
}

double area_m2(const Area& area) {
  double sum = 0.0;
  for (const Polygon& polygon : area) {
    sum += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  }
  return sum;
}

Box2 extent(const Area& area) {
  Box2 box;
  for (const Polygon& polygon : area) {
    for (const Vec2& p : polygon.outer) box.extend(p);
  }
  return box;
}

bool contains(const Area& area, const Vec2& p) {
  bool inside = false;
  bool on_outline = false;
  each_edge(area, [&](const Vec2& a, const Vec2& b) {
    if ((a.y() > p.y()) != (b.y() > p.y())) {
      const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > p.x()) inside = !inside;
    }
    if (!on_outline && distance_to_segment(a, b, p) <= 1e-9) on_outline = true;
  });
  return inside || on_outline;
}

double distance_to_outline(const Area& area, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  each_edge(area, [&](const Vec2& a, const Vec2& b) {
    best = std::min(best, distance_to_segment(a, b, p));
  });
  return best;
}

Area unite(const Area& a, const Area& b) { return boolean(a, b, ClipperLib::ctUnion); }
Area intersect(const Area& a, const Area& b) { return boolean(a, b, ClipperLib::ctIntersection); }
Area subtract(const Area& a, const Area& b) { return boolean(a, b, ClipperLib::ctDifference); }

namespace {

/// Areas of more rings than this are offset ring by ring.
constexpr std::size_t kManyRings = 1000;

/// One outline, counter-clockwise, grown or shrunk.
Paths offset_ring(Path ring, double distance) {
  if (!ClipperLib::Orientation(ring)) std::reverse(ring.begin(), ring.end());
  ClipperLib::ClipperOffset clipper(2.0, kArcTolerance / kLattice);
  clipper.AddPath(ring, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  Paths result;
  clipper.Execute(result, distance / kLattice);
  return result;
}

/// A grown polygon: its outline grown, and its holes, each a shrunk ring, run the other way.
Paths grown(const Polygon& polygon, double distance) {
  Paths paths = offset_ring(to_path(polygon.outer), distance);
  for (const Ring& hole : polygon.holes) {
    for (Path& ring : offset_ring(to_path(hole), -distance)) {
      std::reverse(ring.begin(), ring.end());
      paths.push_back(std::move(ring));
    }
  }
  return paths;
}

/// Grows all polygons, and unites them from the left to the right.
Paths grown_together(std::vector<Polygon> polygons, double distance) {
  std::stable_sort(polygons.begin(), polygons.end(), [](const Polygon& x, const Polygon& y) {
    return std::pair(x.outer.front().x(), x.outer.front().y()) <
           std::pair(y.outer.front().x(), y.outer.front().y());
  });
  std::vector<Paths> parts;
  for (const Polygon& polygon : polygons) parts.push_back(grown(polygon, distance));
  Paths result;
  unite_in_halves(parts, 0, parts.size(), result);
  return result;
}

/// Of very many rings. Clipper would offset all at once, at a cost that is quadratic in the
/// crossings of rings that overlap or vanish.
Area offset_by_rings(const Area& a, double distance) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  if (distance >= 0.0) {
    clipper.AddPaths(grown_together(a, distance), ClipperLib::ptSubject, true);
  } else {
    std::vector<Polygon> holes;
    for (const Polygon& polygon : a) {
      clipper.AddPaths(offset_ring(to_path(polygon.outer), distance), ClipperLib::ptSubject, true);
      for (const Ring& hole : polygon.holes) holes.push_back({hole, {}});
    }
    clipper.AddPaths(grown_together(std::move(holes), -distance), ClipperLib::ptClip, true);
  }
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return to_area(tree);
}

}  // namespace

Area offset(const Area& a, double distance) {
  std::size_t rings = a.size();
  for (const Polygon& polygon : a) rings += polygon.holes.size();
  if (rings > kManyRings) return offset_by_rings(a, distance);
  ClipperLib::ClipperOffset clipper(2.0, kArcTolerance / kLattice);
  clipper.AddPaths(to_paths(a), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  ClipperLib::PolyTree tree;
  clipper.Execute(tree, distance / kLattice);
  return to_area(tree);
}

Area from_rings(const std::vector<Ring>& rings, bool nonzero) {
  ClipperLib::Clipper clipper;
  clipper.StrictlySimple(true);
  for (const Ring& ring : rings) clipper.AddPath(to_path(ring), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  const auto fill = nonzero ? ClipperLib::pftNonZero : ClipperLib::pftEvenOdd;
  clipper.Execute(ClipperLib::ctUnion, tree, fill, fill);
  return to_area(tree);
}

namespace {

/// Douglas-Peucker between two kept points.
void keep_between(const Ring& ring, std::size_t first, std::size_t last, double tolerance,
                  std::vector<char>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> stack{{first, last}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    double worst = tolerance;
    std::size_t at = 0;
    for (std::size_t k = i + 1; k < j; ++k) {
      const double d =
          distance_to_segment(ring[i % ring.size()], ring[j % ring.size()], ring[k % ring.size()]);
      if (d > worst) {
        worst = d;
        at = k;
      }
    }
    if (at == 0) continue;
    keep[at % ring.size()] = 1;
    stack.emplace_back(i, at);
    stack.emplace_back(at, j);
  }
}

Ring simplify(const Ring& ring, double tolerance) {
  if (ring.size() < 4) return ring;
  // Two anchors that surely are corners: the lexicographically smallest point and the one farthest
  // from it.
  std::size_t a = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (std::pair(ring[i].x(), ring[i].y()) < std::pair(ring[a].x(), ring[a].y())) a = i;
  }
  std::size_t b = a;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if ((ring[i] - ring[a]).squaredNorm() > (ring[b] - ring[a]).squaredNorm()) b = i;
  }
  std::vector<char> keep(ring.size(), 0);
  keep[a] = keep[b] = 1;
  const std::size_t b_after = b < a ? b + ring.size() : b;
  keep_between(ring, a, b_after, tolerance, keep);
  keep_between(ring, b_after, a + ring.size(), tolerance, keep);
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (keep[i] != 0) result.push_back(ring[i]);
  }
  return result;
}

}  // namespace

Area simplify(const Area& a, double tolerance) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : a) {
    rings.push_back(simplify(polygon.outer, tolerance));
    for (const Ring& hole : polygon.holes) rings.push_back(simplify(hole, tolerance));
  }
  // Simplified rings may touch: the union makes a clean area of them again.
  return from_rings(rings, true);
}

std::vector<std::pair<double, double>> clip_segment(const Area& area, const Vec2& a,
                                                    const Vec2& b) {
  const Vec2 d = b - a;
  std::vector<double> cuts{0.0, 1.0};
  each_edge(area, [&](const Vec2& p, const Vec2& q) {
    const Vec2 e = q - p;
    const double denominator = cross(d, e);
    if (denominator == 0.0) return;
    const Vec2 w = p - a;
    const double t = cross(w, e) / denominator;
    const double s = cross(w, d) / denominator;
    if (t > 0.0 && t < 1.0 && s >= -1e-12 && s <= 1.0 + 1e-12) cuts.push_back(t);
  });
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::pair<double, double>> inside;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i + 1] <= cuts[i]) continue;
    if (!contains(area, a + 0.5 * (cuts[i] + cuts[i + 1]) * d)) continue;
    if (!inside.empty() && inside.back().second == cuts[i]) {
      inside.back().second = cuts[i + 1];
    } else {
      inside.emplace_back(cuts[i], cuts[i + 1]);
    }
  }
  return inside;
}

Vec2 inner_point(const Area& area) {
  constexpr int kSteps = 20;
  const Box2 box = extent(area);
  const auto at = [&](double right, double up) -> Vec2 {
    return box.min + box.size().cwiseProduct(Vec2(right, up)) / double{kSteps};
  };
  Vec2 best = at(0.5 * kSteps, 0.5 * kSteps);
  double most = -1.0;
  for (int i = 1; i < kSteps; ++i) {
    for (int j = 1; j < kSteps; ++j) {
      const Vec2 p = at(i, j);
      const double inside = contains(area, p) ? distance_to_outline(area, p) : -1.0;
      if (inside > most) {
        most = inside;
        best = p;
      }
    }
  }
  if (most >= 0.0) return best;
  for (int j = 1; j < kSteps; ++j) {
    for (const auto& [from, to] : clip_segment(area, at(0, j), at(kSteps, j))) {
      if (to - from <= most) continue;
      most = to - from;
      best = at(0.5 * (from + to) * kSteps, j);
    }
  }
  return best;
}

}  // namespace swathplan

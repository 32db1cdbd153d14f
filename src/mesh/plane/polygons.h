#pragma once

#include <utility>
#include <vector>

#include "mesh/base/frame.h"
#include "mesh/plane/box.h"

namespace swathplan {

/// A closed ring, local metres, without its first point repeated.
using Ring = std::vector<Vec2>;

/// One outer ring (counter-clockwise) and its holes (clockwise).
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// Any number of disjoint polygons; the value of every area in swathplan.
using Area = std::vector<Polygon>;

/// Signed area of a ring, square metres, positive counter-clockwise.
[[nodiscard]] double signed_area(const Ring& ring);
/// Area, square metres, holes taken off.
[[nodiscard]] double area_m2(const Area& area);
[[nodiscard]] Box2 extent(const Area& area);
/// True inside or on the outline (even-odd over all rings).
[[nodiscard]] bool contains(const Area& area, const Vec2& p);
/// Distance to the nearest outline, metres.
[[nodiscard]] double distance_to_outline(const Area& area, const Vec2& p);

/// A point well inside an area, for a label or to say where it is: the best of a lattice of 19 x 19
/// points; of an area too thin for them, the middle of the longest run along one of its rows. The
/// middle of its extent only where it has no inside.
[[nodiscard]] Vec2 inner_point(const Area& area);

/// Boolean operations and offsetting through Clipper on a 0.1 mm lattice (kLattice): exact there,
/// so results never cross themselves. Cost O(n log n).
[[nodiscard]] Area unite(const Area& a, const Area& b);
[[nodiscard]] Area intersect(const Area& a, const Area& b);
[[nodiscard]] Area subtract(const Area& a, const Area& b);
/// Grows (distance > 0) or shrinks (< 0) by `distance` metres with round corners.
[[nodiscard]] Area offset(const Area& a, double distance);
/// Rings of any orientation and nesting -> polygons; `nonzero`: filled where the winding number is
/// not 0, else even-odd. Rings under three distinct points vanish.
[[nodiscard]] Area from_rings(const std::vector<Ring>& rings, bool nonzero);
/// Drops points that lie within `tolerance` metres of the outline that is left.
[[nodiscard]] Area simplify(const Area& a, double tolerance);

/// The parts of the segment a-b that lie inside the area, as parameter intervals in [0, 1], sorted.
[[nodiscard]] std::vector<std::pair<double, double>> clip_segment(const Area& area, const Vec2& a,
                                                                  const Vec2& b);

inline constexpr double kLattice = 1e-4;  ///< metres; far under any survey's accuracy

}  // namespace swathplan

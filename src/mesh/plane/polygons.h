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

/// Any number of polygons that do not overlap. Every area in swathplan is one. Functions below that
/// return an area sort it, the largest polygon first.
using Area = std::vector<Polygon>;

/// Signed area of a ring, square metres, positive counter-clockwise. 0 under three points.
[[nodiscard]] double signed_area(const Ring& ring);
/// Area, square metres, holes taken off.
[[nodiscard]] double area_m2(const Area& area);
/// The box around all outer rings; empty for an empty area.
[[nodiscard]] Box2 extent(const Area& area);
/// True inside (even-odd over all rings) or within 1e-9 m of the outline. O(points).
[[nodiscard]] bool contains(const Area& area, const Vec2& p);
/// Distance to the nearest outline, metres; infinite for an empty area. O(points).
[[nodiscard]] double distance_to_outline(const Area& area, const Vec2& p);

/// A point well inside an area, for a label or to say where it is: the best of a lattice of 19 x 19
/// points; of an area too thin for them, the middle of the longest run along one of its rows. The
/// middle of its extent only where it has no inside.
[[nodiscard]] Vec2 inner_point(const Area& area);

/// Boolean operations and offsetting through Clipper. Points are rounded to a lattice of 0.1 mm
/// (kLattice) first, and new corners, where outlines cross, are rounded to it too. Rings of a
/// result may touch. Cost about O(n log n) where few outlines cross; it grows with the crossings.
[[nodiscard]] Area unite(const Area& a, const Area& b);
[[nodiscard]] Area intersect(const Area& a, const Area& b);
[[nodiscard]] Area subtract(const Area& a, const Area& b);
/// Grows (distance > 0) or shrinks (< 0) by `distance` metres with round corners, whose arcs become
/// chords within 0.02 m of them. An area that is too narrow vanishes.
[[nodiscard]] Area offset(const Area& a, double distance);
/// Rings of any orientation and nesting -> polygons; `nonzero`: filled where the winding number is
/// not 0, else even-odd. Rings under three distinct points vanish.
[[nodiscard]] Area from_rings(const std::vector<Ring>& rings, bool nonzero);
/// Drops points that lie within `tolerance` metres of the ring that is left of theirs (Douglas-
/// Peucker). A ring that is thinner than that may vanish; rings that come to overlap are united.
[[nodiscard]] Area simplify(const Area& a, double tolerance);

/// The parts of the segment a-b that lie inside the area, as parameter intervals in [0, 1], sorted.
/// None for an empty area. O(points) for each crossing of the outline.
[[nodiscard]] std::vector<std::pair<double, double>> clip_segment(const Area& area, const Vec2& a,
                                                                  const Vec2& b);

inline constexpr double kLattice = 1e-4;  ///< metres; far under any survey's accuracy

}  // namespace swathplan

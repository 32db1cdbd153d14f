#pragma once

#include <cstddef>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// The corners of all rings.
[[nodiscard]] std::size_t corners_of(const std::vector<Ring>& rings);

/// A chain of the corners of a closed ring that every point of the ring lies near: within
/// `within_m` metres of the chord between the two chosen corners around it. In sailing order; the
/// first corner is kept. Cost O(n): no corner is looked at more than kLookAhead times.
[[nodiscard]] Ring few_corners(const Ring& ring, double within_m);

/// Areas with few corners on either side of an outline, for outlines of any number of corners.
struct Bracket {
  Area within;  ///< lies in the area of the rings
  Area around;  ///< contains the area of the rings
};

/// Brackets the area of `rings` (even-odd, as a polygon with its holes). The outlines of both lie
/// within `tolerance_m` of the rings; what is thinner than twice that is gone from `within` and
/// filled in `around`.
/// Method: the outline becomes a band. Chords of few_corners, each a rectangle that holds all of
/// its part of the ring, are united in pairs of pairs. The ring lies in the band, so that each
/// piece of the plane beside it is inside or outside as a whole; one corner of its border tells
/// which. Containment thus does not depend on how the chords cross.
/// `tolerance_m` >= kLeastTolerance.
[[nodiscard]] Bracket bracket(const std::vector<Ring>& rings, double tolerance_m);

/// Metres; the bracket's margins are then some steps of the lattice.
inline constexpr double kLeastTolerance = 50.0 * kLattice;

}  // namespace swathplan

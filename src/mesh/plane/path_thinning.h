#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// The points of a path that are enough to follow it.
struct ThinnedPath {
  std::vector<std::size_t> kept;    ///< indices, rising; the first and the last point among them
  double largest_distance_m = 0.0;  ///< of a point of the path to the thinned path; measured
};

/// Whether the points between two kept ones, given by their indices, may be left out. Asked only
/// where there are any.
using StraightRule = std::function<bool(std::size_t first, std::size_t last)>;

/// Leaves out points of a path that lie within `tolerance_m` of the straight between the two kept
/// ones around them (Douglas-Peucker). Points with `keep[i]` stay; an empty `keep` asks for none.
/// Guarantees: (1) largest_distance_m <= tolerance_m; (2) it bounds the distance of any point of
/// one path, between vertices too, to the other; (3) `rule`, if there is one, allows each straight
/// between two kept points that leaves out others. A path of fewer than three points is kept whole.
/// About O(n log n): long stretches are taken in pieces, whose ends are kept.
[[nodiscard]] ThinnedPath thin_path(const std::vector<Vec2>& path, const std::vector<bool>& keep,
                                    double tolerance_m, const StraightRule& rule = {});

}  // namespace swathplan

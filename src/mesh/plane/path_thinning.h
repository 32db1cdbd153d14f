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

/// Whether the points between two kept ones, given by their indices, may be left out. It is asked
/// only if there are such points.
using StraightRule = std::function<bool(std::size_t first, std::size_t last)>;

/// Leaves out points of a path that lie within `tolerance_m` of the straight between the two kept
/// points around them (Douglas-Peucker). Points with `keep[i]` stay; an empty `keep` demands none.
/// Guarantees: (1) largest_distance_m <= tolerance_m; (2) no point of one path lies farther than
/// that from the other path, points between vertices included; (3) `rule`, if given, allows each
/// straight that leaves out points. A path of fewer than three points is kept whole. About O(n log
/// n): long stretches are cut into pieces, whose ends are kept.
[[nodiscard]] ThinnedPath thin_path(const std::vector<Vec2>& path, const std::vector<bool>& keep,
                                    double tolerance_m, const StraightRule& rule = {});

}  // namespace swathplan

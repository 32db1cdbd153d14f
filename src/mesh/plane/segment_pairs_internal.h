#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan::internal {

/// Pairs i < j of a path's segments that may come within `reach_m` of each other. They are sorted,
/// each pair comes once, and neighbours are among them. About O(n log n) for paths that spread over
/// the plane.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> segment_pairs(
    const std::vector<Vec2>& path, double reach_m);

}  // namespace swathplan::internal

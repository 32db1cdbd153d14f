#pragma once

#include <cstddef>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// How often a path of straight segments crosses itself. Each of these counts once: two segments
/// that cross between their ends; two that lie on each other over some length; a corner on another
/// segment or corner, if the path changes sides there. Neighbouring segments do not count, nor do
/// places where the path touches itself and turns away. 0 for a path of fewer than four points.
/// Exact predicates decide. About O(n log n) for paths that spread over the plane.
[[nodiscard]] std::size_t self_crossings(const std::vector<Vec2>& path);

}  // namespace swathplan

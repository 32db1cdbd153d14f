#pragma once

#include <cstddef>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// How often a path of straight segments crosses itself. Counted once each: two segments that cross
/// inside one another; two that run over one another for some length; a corner that lies inside
/// another segment or on another corner while the path passes from one side to the other there.
/// Not counted: neighbouring segments, and places where the path touches itself and turns away.
/// Exact predicates decide. About O(n log n) for paths that spread over the plane.
[[nodiscard]] std::size_t self_crossings(const std::vector<Vec2>& path);

}  // namespace swathplan

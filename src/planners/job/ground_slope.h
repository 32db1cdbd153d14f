#pragma once

#include <optional>

#include "mesh/seafloor.h"

namespace swathplan {

/// How steep the ground is about p, over `span_m`: the gradient of the depth from two pairs of
/// depths, metres a metre. Empty where one of them is unknown.
[[nodiscard]] std::optional<Vec2> depth_gradient(const DepthQuery& depths, const Vec2& p,
                                                 double span_m);

}  // namespace swathplan

#pragma once

#include "mesh/seafloor.h"

namespace swathplan {

/// The faces of the seafloor whose boxes meet `box`, whole, and their vertices in the same order.
/// The frame stays. Empty where none does. O(faces).
[[nodiscard]] Seafloor cropped(const Seafloor& seafloor, const Box2& box);

}  // namespace swathplan

#pragma once

#include "mesh/seafloor.h"

namespace swathplan {

/// The part of the seafloor that lies at or below `z` (metres, local frame): faces that straddle
/// the level are cut along it, with one shared crossing point per mesh edge, so no crack opens.
/// What is above is land and left out; an all-land input gives an empty mesh. O(n).
/// Guarantees: (1) every vertex of the result has z <= level; (2) vertices that stay keep their
/// coordinates exactly.
[[nodiscard]] Seafloor below_level(const Seafloor& seafloor, double z);

}  // namespace swathplan

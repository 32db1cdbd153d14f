#pragma once

#include "mesh/seafloor.h"

namespace swathplan {

/// The part of the seafloor that lies at or below `z` (metres, local frame). Faces that cross the
/// level are cut along it. Each mesh edge has one crossing point, which its faces share, so no
/// crack opens. What lies above is land and left out; if all is land, the mesh is empty. O(n).
/// Guarantees: (1) every vertex of the result has z <= level; (2) vertices that stay keep their
/// coordinates exactly.
[[nodiscard]] Seafloor below_level(const Seafloor& seafloor, double z);

}  // namespace swathplan

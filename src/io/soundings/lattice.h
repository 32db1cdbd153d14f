#pragma once

#include "io/grids/surface_data.h"

namespace swathplan {

/// Joins points on a lattice along the axes as a grid joins its cells. Returns true if it did. The
/// steps of a lattice are equal to within a twentieth, and most of its points have neighbours.
bool join_lattice(SurfaceData& points);

}  // namespace swathplan

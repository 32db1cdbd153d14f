#pragma once

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// If the points lie on a lattice along the axes (steps equal to within a twentieth, most points
/// with neighbours), joins them as a grid joins its cells and returns true.
bool join_lattice(SurfaceData& points);

}  // namespace swathplan

#pragma once

#include "io/grids/surface_data.h"

namespace swathplan {

/// Points at the same place to the last bit become one, the shoalest; the order stays. Says how
/// many were left out.
void keep_shoalest_places(SurfaceData& points, bool z_down);

}  // namespace swathplan

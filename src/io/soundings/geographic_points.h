#pragma once

#include "io/grids/surface_data.h"

namespace swathplan {

/// Mends points in degrees: a latitude beyond 90 is a longitude, so that the axes change places,
/// and longitudes on both sides of 180 degrees are brought to one side. Says so in a note. True if
/// the points changed; faces stay as they were joined.
bool mend_geographic_points(SurfaceData& points);

}  // namespace swathplan

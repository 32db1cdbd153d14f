#pragma once

#include "io/charts/chart_shapes_internal.h"

namespace swathplan {

/// Everything within `buffer_m` of the shapes, local metres. The result may reach up to a tenth of
/// a metre farther, never less far. Without a buffer lines and points have no area.
[[nodiscard]] Area area_around(const ChartShapes& shapes, double buffer_m);

/// The box around the shapes.
[[nodiscard]] Box2 extent(const ChartShapes& shapes);

/// The parts of the polygons in the box; lines and points stay as they are.
void clip_polygons(ChartShapes& shapes, const Box2& box);

}  // namespace swathplan

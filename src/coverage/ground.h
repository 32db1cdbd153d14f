#pragma once

#include <optional>

#include "coverage/tracing/ray_scene.h"
#include "mesh/plane/polygons.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// Where routes are planned and scored. It is built once a site and shared. What it points to must
/// outlive it.
struct Ground {
  const Seafloor* seafloor = nullptr;  ///< the original mesh, not the planning mesh
  const DepthQuery* depths = nullptr;
  Area survey_area;  ///< to be covered: its cells count
  Area water;        ///< where the boat may be: deep enough, clear of walls and no-go
  /// Needed for scoring. Planners use it to simulate their candidates; without it they take their
  /// first candidate.
  const RayScene* scene = nullptr;
  /// A corner that scoring cells lie at; empty: that of the area's bounding box. Grids over parts
  /// of one area then have cells in common.
  std::optional<Vec2> lattice = {};
  /// Known land and no-go, outside the water. Ground that nobody has sounded is no part of it.
  Area land = {};
};

}  // namespace swathplan

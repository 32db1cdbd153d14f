#pragma once

#include "mesh/base/angle.h"
#include "mesh/planar/planar_mesh.h"

namespace swathplan {

struct QuadMeshOptions {
  double side_m = 25.6;  ///< target side of a quad, > 0
  Angle turn = {};       ///< of the lattice against the area's main direction
};

/// Cuts the whole area into right-angled quads near `side_m` wide. A lattice along the area's main
/// direction, fitted to a whole number of steps, cuts each polygon of the area. Cells inside stay
/// quads. What the outline leaves of a cell is one polygon if NUC can walk it (face_merging.h),
/// else several. Pieces far smaller than a cell join the neighbour with the longest common edge. A
/// corner of one face on the side of another is a corner of that one too, so the mesh is
/// conforming. Guarantees: (1) the union of the faces is the area that face_layout() makes of
/// `area`, to rounding; (2) faces meet edge to edge; (3) polygons of the area do not connect; (4) a
/// NUC skeleton of the mesh, corners rounded, does not cross itself. An area smaller than a cell
/// gives one face if its shape allows. Cost: about O(n log n).
/// @throws InvalidInput for an empty area; UsageError for a side that is not > 0.
[[nodiscard]] PlanarMesh quad_mesh(const Area& area, const QuadMeshOptions& options);

}  // namespace swathplan

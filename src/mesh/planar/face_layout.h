#pragma once

#include "mesh/base/angle.h"
#include "mesh/planar/planar_mesh.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// An area made ready for a lattice of faces. Its main direction lies along x. Its outline is only
/// as fine as faces should follow it.
struct FaceLayout {
  Area area;        ///< turned by -turned_by about the origin
  Angle turned_by;  ///< counter-clockwise, from x to the lattice's first direction
};

/// Lays the area out for faces of `size_m`: the hypotenuse of triangles or the side of quads. Their
/// lattice is turned by `turn` against the direction that most of the outline follows. The new
/// outline lies inside the given one; details under 2 % of `size_m` are smoothed away.
/// @throws InvalidInput for an empty area.
[[nodiscard]] FaceLayout face_layout(const Area& area, double size_m, Angle turn);

/// @throws InvalidInput if the area was too small for a single face.
void require_faces(const PlanarMesh& mesh);

/// p turned counter-clockwise about the origin.
[[nodiscard]] Vec2 rotated(const Vec2& p, Angle by);

/// The step near `wanted` that fits into `length` a whole number of times, at least once.
[[nodiscard]] double fitted_step(double length, double wanted);

}  // namespace swathplan

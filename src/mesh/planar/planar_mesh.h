#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// A polygon mesh in the water plane that a path is planned on; local metres.
/// Faces are simple polygons, counter-clockwise, and meet edge to edge.
struct PlanarMesh {
  using Face = std::vector<std::uint32_t>;
  std::vector<Vec2> vertices;
  std::vector<Face> faces;
};

/// An edge that two faces share. `face[0] < face[1]`. In face k the edge runs from the corner with
/// the number `edge[k]` to the next one.
struct SharedEdge {
  std::array<std::uint32_t, 2> face;
  std::array<std::uint32_t, 2> edge;
};

/// All shared edges in the order of (face[0], edge[0]). O(n).
/// @throws InvalidInput if an edge belongs to more than two faces or twice in the same direction.
[[nodiscard]] std::vector<SharedEdge> shared_edges(const PlanarMesh& mesh);

/// Edge-connected parts of a mesh: part index per face, numbered by their lowest face.
[[nodiscard]] std::vector<std::uint32_t> connected_parts(const PlanarMesh& mesh,
                                                         const std::vector<SharedEdge>& edges);

[[nodiscard]] double face_area(const PlanarMesh& mesh, std::uint32_t face);
[[nodiscard]] Vec2 face_centroid(const PlanarMesh& mesh, std::uint32_t face);  ///< corners' mean

struct PlanarMeshOptions {
  double hypotenuse_m = 25.6;  ///< target length of a face's longest edge, > 0
  Angle turn = {};             ///< of the lattice against the area's main direction
};

/// Triangulates the whole area up to its outline. Faces are nearly right isosceles triangles with a
/// hypotenuse near `hypotenuse_m`. A square lattice is laid along the area's main direction. A
/// constrained Delaunay triangulation joins it with the outline, and faces that are too large are
/// refined. Channels narrower than a face get smaller faces.
/// Guarantees: (1) the union of the faces is the area, up to outline details under 2 % of the
/// hypotenuse; (2) no face leaves the area; (3) parts of the area do not connect.
/// Method: [larrazabal-mdnuc] section III.B.1.
/// @throws InvalidInput for an empty area; UsageError for a hypotenuse that is not > 0.
[[nodiscard]] PlanarMesh planar_mesh(const Area& area, const PlanarMeshOptions& options);

}  // namespace swathplan

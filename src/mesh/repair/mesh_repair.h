#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// What was found in a mesh and what was done about it.
struct MeshHealth {
  std::size_t vertices = 0, faces = 0;  ///< after repair
  std::size_t duplicate_vertices = 0;   ///< merged (same position to the last bit)
  std::size_t unused_vertices = 0;      ///< removed
  std::size_t degenerate_faces = 0;     ///< removed: repeated corner or no area
  std::size_t duplicate_faces = 0;      ///< removed: same three corners
  std::size_t flipped_faces = 0;        ///< turned to look up
  std::size_t non_manifold_edges = 0;   ///< edges of more than two faces, split apart
  std::size_t components = 0;           ///< edge-connected parts after repair
  std::size_t boundary_loops = 0;       ///< closed loops of border edges after repair
  std::size_t overhanging_faces = 0;    ///< undersides and outer sides of closed bodies: removed
  std::size_t vertical_faces = 0;       ///< kept: walls
  std::vector<std::string> notes;       ///< one sentence per thing mended
};

/// A seafloor that keeps the invariants of `Seafloor` and a report of what was mended.
struct RepairedSeafloor {
  Seafloor seafloor;
  MeshHealth health;
};

/// Mends a mesh. It merges equal vertices, drops degenerate and duplicate faces, takes the
/// underside off closed bodies, turns every face up, splits non-manifold edges and drops unused
/// vertices. No vertex moves.
/// @throws InvalidInput if no face has a plan area (empty mesh, flat vertical sheet), or for a
///   coordinate that is not finite or an index out of range; the message names the element.
[[nodiscard]] RepairedSeafloor repair(Seafloor soup);

/// Counts vertices, faces, parts, boundary loops, walls and non-manifold edges of a mesh as it is.
/// Indices must be in range. O(n).
[[nodiscard]] MeshHealth assess(const Seafloor& seafloor);

}  // namespace swathplan

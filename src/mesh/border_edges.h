#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// Edges of the seafloor that belong to one face only. Each runs as in its face, so the data lies
/// on its left. Vertices at the same position count as one, so that a seam between split vertices
/// is no border. An empty seafloor has none. O(faces) where few faces meet at a vertex.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> border_edges(const Seafloor& seafloor);

}  // namespace swathplan

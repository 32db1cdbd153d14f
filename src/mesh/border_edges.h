#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

/// Edges of the seafloor that one face alone uses, each running as in its face (data on its left).
/// Vertices at the same position count as one, so that a seam between split vertices is no border.
/// An empty seafloor has none. O(faces) for meshes of bounded valence.
[[nodiscard]] std::vector<std::array<std::uint32_t, 2>> border_edges(const Seafloor& seafloor);

}  // namespace swathplan

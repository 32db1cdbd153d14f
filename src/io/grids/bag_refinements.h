#pragma once

#include <filesystem>
#include <optional>

#include "io/grids/surface_data.h"

namespace swathplan {

/// Reads the refinements of a variable-resolution BAG, not its coarse overview. Every node of the
/// refinements becomes a vertex, at its place and with its depth. Refinements that make one lattice
/// are joined as a grid is; others by a Delaunay triangulation whose edges are no longer than the
/// diagonal of a refined cell, or than the gap between neighbouring refinements. A cell without
/// refinements keeps its overview node. Cost: O(n log n).
/// @throws InvalidInput if the refinements cannot be read or make no surface.
[[nodiscard]] SurfaceData read_refinements(const std::filesystem::path& path,
                                           std::optional<double> nodata = {});

}  // namespace swathplan

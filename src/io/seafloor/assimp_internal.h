#pragma once

#include <filesystem>

#include "io/grids/surface_data.h"

namespace swathplan {

/// Reads the triangles of any mesh format that assimp knows. Node transforms are applied. Lengths
/// are metres if the format states its unit. Formats that are y up are turned z up. Coordinates
/// pass through 32-bit floats.
/// @throws InvalidInput if assimp cannot read it.
[[nodiscard]] SurfaceData read_with_assimp(const std::filesystem::path& path);
[[nodiscard]] bool assimp_reads(const std::string& extension);

}  // namespace swathplan

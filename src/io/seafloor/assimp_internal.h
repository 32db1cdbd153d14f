#pragma once

#include <filesystem>

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// Reads any mesh format that assimp knows: triangles with node transforms applied, in metres where
/// the format states its unit, turned z up where the format is y up. Coordinates pass through
/// 32-bit floats. @throws InvalidInput if assimp cannot read it.
[[nodiscard]] SurfaceData read_with_assimp(const std::filesystem::path& path);
[[nodiscard]] bool assimp_reads(const std::string& extension);

}  // namespace swathplan

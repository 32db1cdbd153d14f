#pragma once

#include <filesystem>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True if the extension is that of a mesh format that can be read.
[[nodiscard]] bool is_mesh_extension(const std::string& extension);

/// Reads the triangles of a mesh file, z up. Polygons are cut into triangles. OBJ, PLY, OFF and
/// ASCII STL keep every bit of their doubles. Other formats are read through assimp and hold 32-bit
/// floats. Their node transforms are applied. Formats that are y up (glTF, COLLADA) are turned z
/// up.
/// @throws InvalidInput for a truncated or garbled file, an index out of range, no faces.
[[nodiscard]] SurfaceData read_mesh(const std::filesystem::path& path);

/// The same without a process of its own, which keeps crashes of foreign readers away: for that
/// process, and for fuzzers.
[[nodiscard]] SurfaceData read_mesh_unguarded(const std::filesystem::path& path);

}  // namespace swathplan

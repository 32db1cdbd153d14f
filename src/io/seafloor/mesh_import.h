#pragma once

#include <filesystem>

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// True if the extension is that of a mesh format that can be read.
[[nodiscard]] bool is_mesh_extension(const std::string& extension);

/// Reads the triangles of a mesh file, polygons triangulated, z up. OBJ, PLY, OFF and ASCII STL
/// keep every bit of their doubles (CGAL); other formats hold 32-bit floats (assimp), their node
/// transforms are applied, and y-up formats (glTF, COLLADA) are turned upright.
/// @throws InvalidInput for a truncated or garbled file, an index out of range, no faces.
[[nodiscard]] SurfaceData read_mesh(const std::filesystem::path& path);

}  // namespace swathplan

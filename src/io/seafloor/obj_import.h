#pragma once

#include <filesystem>
#include <vector>

#include "io/grids/surface_data.h"

namespace swathplan {

/// A polygon of any number of corners, as mesh files store them.
using SoupPolygon = std::vector<std::size_t>;

/// Reads vertices and faces of a Wavefront OBJ in double precision. Negative indices count from the
/// last vertex backwards. Everything else is left out (normals, textures, groups, lines).
/// @throws InvalidInput naming the line that cannot be read.
void read_obj(const std::filesystem::path& path, std::vector<Vec3>& vertices,
              std::vector<SoupPolygon>& polygons);

}  // namespace swathplan

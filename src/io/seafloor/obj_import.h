#pragma once

#include <filesystem>
#include <vector>

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// A polygon of any number of corners, as mesh files store them.
using SoupPolygon = std::vector<std::size_t>;

/// Reads vertices and faces of a Wavefront OBJ in double precision; negative indices count from
/// the end; all else (normals, textures, groups, lines) is passed over.
/// @throws InvalidInput naming the line that cannot be read.
void read_obj(const std::filesystem::path& path, std::vector<Vec3>& vertices,
              std::vector<SoupPolygon>& polygons);

}  // namespace swathplan

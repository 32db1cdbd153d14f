#pragma once

#include <filesystem>
#include <vector>

#include "io/seafloor/obj_import.h"

namespace swathplan {

enum class SoupFormat { ply, off, ascii_stl };

/// Reads a PLY, OFF or ASCII STL in double precision through CGAL. Checks come first, because CGAL
/// would hang on some broken files and return garbage for others.
/// @throws InvalidInput for truncated or garbled files.
void read_soup(const std::filesystem::path& path, SoupFormat format, std::vector<Vec3>& vertices,
               std::vector<SoupPolygon>& polygons);

/// Cuts polygons into triangles that follow their outline. `path` is for the message.
/// @throws InvalidInput for an index out of range or a polygon of too many corners.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::filesystem::path& path, const std::vector<Vec3>& vertices,
    const std::vector<SoupPolygon>& polygons);

}  // namespace swathplan

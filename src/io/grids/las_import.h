#pragma once

#include <filesystem>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True for LAS and LAZ files, by their first bytes.
[[nodiscard]] bool is_las(const std::filesystem::path& path);

/// Reads the points of a LAS file (1.0 to 1.4, not compressed), z positive up. Points that the file
/// marks as withheld or as noise are left out; where it marks points as bathymetric (class 40),
/// only these are read. The CRS comes from the file's WKT or its GeoTIFF keys.
/// @throws InvalidInput if it is compressed (LAZ), cut off, or holds fewer than three points.
[[nodiscard]] SurfaceData read_las(const std::filesystem::path& path, bool z_positive_down);

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <optional>

#include "io/seafloor/surface_data.h"

namespace swathplan {

/// Reads x, y, z rows separated by space, tab, comma or semicolon; '#', '//', '%' and '!' open
/// comments. Columns may be named (x y z, lon lat depth, easting northing elevation, ...): 'depth'
/// means positive down, lon and lat mean WGS 84. Points at the same place are merged, the shoalest
/// is kept. A regular lattice along the axes comes back joined as a grid joins its cells.
/// @throws InvalidInput naming the line that cannot be read, or with fewer than three places.
[[nodiscard]] SurfaceData read_soundings(const std::filesystem::path& path, bool z_positive_down,
                                         std::optional<double> nodata = {});

/// Joins scattered points to a Delaunay surface without triangles that have an edge longer than
/// `longest_edge` (units of the points; empty: chosen from the spacing of the points). Drops points
/// that no triangle is left for. Returns the limit used.
/// @throws InvalidInput if no triangle is left.
double join_soundings(SurfaceData& points, std::optional<double> longest_edge);

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <optional>

#include "io/grids/surface_data.h"

namespace swathplan {

/// Reads rows of x, y, z that are separated by space, tab, comma or semicolon. '#', '//', '%' and
/// '!' open comments. Columns may have names (x y z, lon lat depth, easting northing elevation,
/// ...). The name 'depth' means positive down; lon and lat mean WGS 84. Of several soundings at one
/// place the shoalest is kept. Soundings on a lattice along the axes are joined as a grid joins its
/// cells.
/// @throws InvalidInput naming the line that cannot be read, or with fewer than three places.
[[nodiscard]] SurfaceData read_soundings(const std::filesystem::path& path, bool z_positive_down,
                                         std::optional<double> nodata = {});

/// Joins scattered points to a Delaunay surface. Triangles with an edge longer than `longest_edge`
/// are left out (units of the points; empty: chosen from the spacing of the points). Points without
/// a triangle are dropped. Returns the limit used.
/// @throws InvalidInput if no triangle is left.
double join_soundings(SurfaceData& points, std::optional<double> longest_edge);

}  // namespace swathplan

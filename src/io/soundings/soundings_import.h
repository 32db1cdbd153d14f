#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/grids/surface_data.h"

namespace swathplan {

/// How to read rows of soundings where the file does not say.
struct SoundingsOptions {
  bool z_positive_down = false;
  std::optional<double> nodata = {};  ///< a z value that means 'no data'
  std::string columns = {};           ///< as `parse_columns` reads it; empty: by their names
  bool z_unit_is_given = false;       ///< then the unit in the name of the z column does not count
};

/// Reads rows of x, y, z that are separated by space, tab, comma or semicolon. '#', '//', '%' and
/// '!' open comments. Columns may have names (x y z, lon lat depth, POINT_X, Depth (ft), ...) and
/// units. The name 'depth' means positive down; lon and lat mean WGS 84. A few lines without
/// numbers are skipped and counted. A note says which columns were taken. Of several soundings at
/// one place the shoalest is kept. Soundings on a lattice along the axes are joined as a grid joins
/// its cells.
/// @throws InvalidInput naming the line that cannot be read, or the columns where it is not clear
/// which are x, y and z, or with fewer than three places; UsageError for a wrong choice of columns.
[[nodiscard]] SurfaceData read_soundings(const std::filesystem::path& path,
                                         const SoundingsOptions& options = {});

/// Joins scattered points to a Delaunay surface. Triangles with an edge longer than `longest_edge`
/// are left out (units of the points; empty: chosen from the spacing of the points). Points without
/// a triangle are dropped. Returns the limit used.
/// @throws InvalidInput if no triangle is left, or if a coordinate is beyond kLargestCoordinate.
double join_soundings(SurfaceData& points, std::optional<double> longest_edge);

/// No map has larger coordinates, in any unit.
inline constexpr double kLargestCoordinate = 1e9;

}  // namespace swathplan

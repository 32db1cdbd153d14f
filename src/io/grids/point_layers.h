#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True if the extension is one of vector data (.shp, .gpkg, .geojson, .000, ...) and GDAL reads a
/// layer from the file.
[[nodiscard]] bool is_point_file(const std::filesystem::path& path);

/// Reads points as soundings. Their depth is the z of the points, positive up (in S-57: the depth),
/// or a column named as a depth or an elevation. `layer` chooses among several layers.
/// @throws InvalidInput if no layer holds points, several do and none is chosen, or no depth is
///   found.
[[nodiscard]] SurfaceData read_point_file(const std::filesystem::path& path, bool z_positive_down,
                                          std::optional<double> nodata = {},
                                          const std::string& layer = {});

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <string>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True for an S-57 cell (.000), and for vector files that hold a layer DEPARE beside SOUNDG or
/// DEPCNT: a chart in another format.
[[nodiscard]] bool is_chart(const std::filesystem::path& path);

/// A fingerprint of a chart as it is read: 'sha1:...' of its file, and of each update that lies
/// beside it, with '+' between. @throws InvalidInput if a file cannot be read.
[[nodiscard]] std::string chart_hash(const std::filesystem::path& path);

/// Reads a chart as a prior seafloor: soundings (SOUNDG), contours (DEPCNT) and depth areas
/// (DEPARE, DRGARE) with their bounds, triangulated as chart_mesh() does. Updates that lie beside
/// an S-57 cell (.001, .002, ...) are applied. Ground is where a depth area is: land and areas that
/// were never surveyed are none. z is positive down, from the chart's sounding datum; coordinates
/// are longitude and latitude.
/// @throws InvalidInput if the cell cannot be read, an update is missing, the usage band is too
///   coarse, or no depth area holds a depth.
[[nodiscard]] SurfaceData read_chart(const std::filesystem::path& path);

}  // namespace swathplan

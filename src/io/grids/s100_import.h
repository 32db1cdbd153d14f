#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/grids/surface_data.h"

namespace swathplan {

/// True for an HDF5 file that names a product of S-100, or holds a coverage of S-102.
[[nodiscard]] bool is_s100(const std::filesystem::path& path);

/// Reads the depths of a bathymetric surface (S-102): positive down, rows from the south, the CRS
/// by its EPSG code. `layer` chooses among several coverages ('BathymetryCoverage.02').
/// @throws InvalidInput if the file is another product of S-100, a field is missing, or the
/// coverage
///   makes no surface.
[[nodiscard]] SurfaceData read_s100(const std::filesystem::path& path,
                                    std::optional<double> nodata = {},
                                    const std::string& layer = {});

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <optional>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// Reads all polygons of a vector file (GeoJSON, GeoPackage, Shapefile, KML, ...) in any CRS,
/// united, in the local metres of `frame`. A file without a CRS is taken to be in the seafloor's,
/// and so is every file if the seafloor has none.
/// @throws InvalidInput if the file cannot be read, holds no polygon, a polygon crosses itself, or,
///   where `data_extent` (local metres) is given, if none of it meets the data.
[[nodiscard]] Area import_area(const std::filesystem::path& path, const Frame& frame,
                               std::optional<Box2> data_extent = {});

}  // namespace swathplan

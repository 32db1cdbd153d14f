#pragma once

#include <filesystem>

#include "mesh/seafloor.h"

namespace swathplan {

/// Writes a seafloor in file coordinates, z up. `.obj` keeps any mesh exactly. `.asc` (Esri ASCII)
/// and `.tif` (GeoTIFF, Float64) need vertices on a square lattice. Places of the lattice without a
/// vertex become nodata. The same seafloor gives the same bytes.
/// @throws UsageError for another extension, or for a grid format where there is no square lattice.
void write_seafloor(const std::filesystem::path& path, const Seafloor& seafloor);

}  // namespace swathplan

#pragma once

#include <filesystem>

namespace swathplan {

/// Registers GDAL's drivers, those of services and databases left out, and keeps GDAL and PROJ from
/// the network: neither a reference in a file nor its text can make this program reach another
/// machine. Does its work once; for use by several threads.
void register_gdal();

/// A virtual raster or layer (VRT) may only draw on files beside it or in folders below, themselves
/// held to the same rule. Does nothing for other files.
/// @throws InvalidInput that names the file and the source it reaches for.
void check_sources_stay_beside(const std::filesystem::path& file);

}  // namespace swathplan

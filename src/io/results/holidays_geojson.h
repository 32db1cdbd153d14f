#pragma once

#include <filesystem>
#include <string>

#include "coverage/holidays.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// The listed holidays as GeoJSON (RFC 7946), the largest first. Each is the polygon around its
/// cells, with rank (from 1), area_m2, cells and cause. x_m, y_m is its position in the input file
/// (x_ft, x_us_ft, x_crs where the file has such units).
/// `outline` says 'cells', or 'box' where the polygon is that of the holiday's box: it came without
/// an outline, or crosses 180 degrees.
/// Without a CRS, coordinates are as in route_geojson.h. The members `holidays` and
/// `holidays_total_m2` of the collection count all holidays, also those that are not listed.
[[nodiscard]] std::string holidays_geojson(const Holidays& holidays, const Frame& frame);

/// Writes it into `folder` as holidays.geojson, or holidays.local.geojson without a CRS, and
/// returns the path written.
/// @throws InvalidInput if the file cannot be written.
std::filesystem::path write_holidays_geojson(const std::filesystem::path& folder,
                                             const Holidays& holidays, const Frame& frame);

}  // namespace swathplan

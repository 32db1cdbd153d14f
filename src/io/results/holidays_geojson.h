#pragma once

#include <filesystem>
#include <string>

#include "coverage/holidays.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// The listed gaps as GeoJSON (RFC 7946), largest first: the box of each gap as a polygon with
/// rank (from 1), area_m2, cells, cause, and its position as x_m, y_m of the input file. Without a
/// CRS as in route_geojson.h. The collection says how many gaps there are in all.
[[nodiscard]] std::string holidays_geojson(const Holidays& holidays, const Frame& frame);

/// Writes it into `folder` as holidays.geojson, or holidays.local.geojson without a CRS, and
/// returns the path written.
/// @throws InvalidInput if the file cannot be written.
std::filesystem::path write_holidays_geojson(const std::filesystem::path& folder,
                                             const Holidays& holidays, const Frame& frame);

}  // namespace swathplan

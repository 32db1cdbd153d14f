#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/exports/route_export.h"

namespace swathplan {

/// A route file that can be exported without the seafloor that it was planned on.
struct ExportableRoute {
  PlacedRoute geographic;  ///< for longitude and latitude; no CRS if the file does not give them
  PlacedRoute planar;      ///< for the coordinates of the file
  std::vector<std::string> notes;  ///< one sentence per thing that was assumed
};

/// Reads a route that read_route takes. Longitude and latitude come from the columns
/// lon_deg,lat_deg, from GeoJSON, or from x_m,y_m and `crs_wkt`. The geographic route has no CRS if
/// the file has none of them. Distances are measured in `crs_wkt`. If `crs_wkt` is empty, they are
/// measured in the UTM zone of the first waypoint.
/// @throws UsageError if `crs_wkt` is in degrees; InvalidInput as read_route does, or where
///   `crs_wkt` puts x_m,y_m elsewhere than lon_deg,lat_deg say.
[[nodiscard]] ExportableRoute read_exportable_route(const std::filesystem::path& path,
                                                    const std::string& crs_wkt);

}  // namespace swathplan

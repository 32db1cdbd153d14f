#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// What a route file need not say.
struct RouteDefaults {
  /// The fan where the file has no angles at all. Empty: such a file is refused. An empty cell of
  /// a file that does have angles means that the sonar is off there.
  std::optional<FanAngles> fan;
  double speed_mps = 2.0;  ///< > 0
};

struct ImportedRoute {
  Route route;
  std::vector<std::string> notes;  ///< one sentence per thing that was assumed
};

/// Reads a route, ours or not; what it is shows in its content, not in its name:
/// - route.csv of this program, or any CSV (comma, semicolon or tab) whose first line names columns
///   x_m,y_m (also x,y or easting,northing: coordinates of the seafloor's file) or lon_deg,lat_deg
///   (also lon,lat or longitude,latitude); all other columns of route.csv may be missing;
/// - GeoJSON of this program, or any LineString, MultiLineString, Feature or FeatureCollection: in
///   longitude and latitude, in a stated `crs`, or in the seafloor's own coordinates where a
///   `local_frame` member says so. Lines that do not meet are joined by straight transits with the
///   sonar off, and a note says so.
/// @throws InvalidInput for anything else; the message names the file, the row or line, what is
///   wrong and what to do.
[[nodiscard]] ImportedRoute read_route(const std::filesystem::path& path, const Frame& frame,
                                       const RouteDefaults& defaults);

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coverage/route/route.h"

namespace swathplan {

/// What a route file need not say.
struct RouteDefaults {
  /// The fan of a file without any angles. Empty: such a file is refused. If a file has angles, an
  /// empty cell means that the sonar is off there.
  std::optional<FanAngles> fan;
  double speed_mps = 2.0;  ///< > 0
};

/// A route as it was read, and what the reader assumed.
struct ImportedRoute {
  Route route;
  /// A sentence that says which fan was taken; empty if the file names all fans.
  std::optional<std::string> fan_note;
  /// One sentence each on kinds and speeds that the file does not name; a leg table tells them.
  std::vector<std::string> leg_notes;
  std::vector<std::string> notes;  ///< one sentence for each other assumption
};

/// Reads a route of this program or of another one. The content decides the format, not the name.
/// - CSV with commas, semicolons or tabs, such as route.csv. The first line must name the columns
///   x_m,y_m or lon_deg,lat_deg. x,y and easting,northing mean x_m,y_m: the coordinates of the
///   seafloor's file. lon,lat and longitude,latitude mean lon_deg,lat_deg. All other columns of
///   route.csv may be missing.
/// - GeoJSON: a LineString, MultiLineString, Feature or FeatureCollection. Its coordinates are
///   longitude and latitude, or those of its `crs` member. If it has a `local_frame` member, they
///   are those of the seafloor's file. Without a line its points are the waypoints.
/// - Missions ('QGC WPL 110', .plan of QGroundControl), GPX, KML and RTZ in longitude and latitude.
/// - Planned lines of HYPACK (LNW), runlines of EIVA (RLN) and drawings (DXF) in the coordinates of
///   the seafloor's file; paths of ROS (YAML of nav_msgs/Path) in metres of its CRS.
/// - Planned lines of Kongsberg SIS (asciiplan) in longitude and latitude.
/// - GeoPackages in their own CRS (route_gpkg_read.h).
/// Lines that do not meet are joined by straight transits with the sonar off. A note then says so.
/// @throws InvalidInput for anything else; the message names the file, the row or line, what is
///   wrong and what to do.
[[nodiscard]] ImportedRoute read_route(const std::filesystem::path& path, const Frame& frame,
                                       const RouteDefaults& defaults);
/// Reads such text; `file` is what messages call it.
[[nodiscard]] ImportedRoute parse_route(std::string_view text, const std::string& file,
                                        const Frame& frame, const RouteDefaults& defaults);

/// What a text looks like. XML is GPX, KML or RTZ.
enum class RouteFormat { csv, geojson, waypoints, plan, xml, lnw, dxf, rln, asciiplan, yaml };
[[nodiscard]] RouteFormat route_format(std::string_view text);
/// True for formats that know nothing but longitude and latitude.
[[nodiscard]] bool is_always_lonlat(RouteFormat format);

}  // namespace swathplan

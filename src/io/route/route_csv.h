#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coverage/route/route.h"
#include "io/route/read_route.h"

namespace swathplan {

/// The route as text (RFC 4180: commas, CRLF), one row per waypoint:
/// `seq,line,kind,log,x_m,y_m,lon_deg,lat_deg,port_deg,stbd_deg,speed_mps,region,status`.
/// - x_m, y_m: coordinates of the input file, to a micrometre. Their names say its unit: x_ft or
///   x_us_ft where these are feet, x_crs for other units of its CRS.
/// - lon_deg, lat_deg: WGS84, to 0.1 mm; empty without a CRS.
/// - port_deg, stbd_deg: half-angles of the fan from nadir; empty where the sonar is off.
/// - status: `infeasible` if the vehicle cannot steer the leg in safe water, else empty.
/// The same route gives the same bytes.
[[nodiscard]] std::string route_csv(const Route& route, const Frame& frame);

/// Writes it to a file.
/// @throws InvalidInput if the route is not valid or the file cannot be written.
void write_route_csv(const std::filesystem::path& path, const Route& route, const Frame& frame);

/// Metres in one unit of the x that such text names; 1 where it names none.
[[nodiscard]] double route_csv_unit_m(std::string_view text);

/// Reads such text, or any CSV that read_route takes; `name` is what messages call it.
/// @throws InvalidInput as read_route does.
[[nodiscard]] ImportedRoute parse_route_csv(std::string_view text, const std::string& name,
                                            const Frame& frame, const RouteDefaults& defaults);

}  // namespace swathplan

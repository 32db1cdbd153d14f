#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coverage/route/route.h"
#include "io/route/read_route.h"

namespace swathplan {

/// The route as GeoJSON (RFC 7946), one LineString feature per leg with the properties of its
/// waypoints: leg, line, kind, log, port_deg, stbd_deg, speed_mps, region, status
/// (`infeasible` or null). Where the fan or the speed changes within a leg, `port_deg_at_points`,
/// `stbd_deg_at_points` or `speed_mps_at_points` lists its values point by point.
/// Without a CRS the coordinates are those of the input file. A `local_frame` member then says so.
[[nodiscard]] std::string route_geojson(const Route& route, const Frame& frame);

/// Writes it into `folder` as route.geojson, or as route.local.geojson without a CRS, and returns
/// the path written.
/// @throws InvalidInput if the route is not valid or the file cannot be written.
std::filesystem::path write_route_geojson(const std::filesystem::path& folder, const Route& route,
                                          const Frame& frame);

/// Reads such text, or any GeoJSON that read_route takes; `name` is what messages call it.
/// @throws InvalidInput as read_route does.
[[nodiscard]] ImportedRoute parse_route_geojson(std::string_view text, const std::string& name,
                                                const Frame& frame, const RouteDefaults& defaults);

}  // namespace swathplan

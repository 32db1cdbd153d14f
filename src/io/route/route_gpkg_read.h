#pragma once

#include <filesystem>
#include <string>

#include "io/route/read_route.h"

namespace swathplan {

/// True for a file of SQLite, which GeoPackages are.
[[nodiscard]] bool is_route_package(const std::filesystem::path& path);

/// The CRS of the route in a GeoPackage as WKT; empty if it has none.
/// @throws InvalidInput if it holds no route.
[[nodiscard]] std::string package_crs(const std::filesystem::path& path);

/// Reads the route of a GeoPackage: of its layer 'waypoints' if that has the columns of route.csv,
/// with all fans and speeds, else the lines of all layers in their order.
/// @throws InvalidInput if it holds neither, or no route can be made of them.
[[nodiscard]] ImportedRoute read_route_gpkg(const std::filesystem::path& path, const Frame& frame,
                                            const RouteDefaults& defaults);

}  // namespace swathplan

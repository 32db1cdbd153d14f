#pragma once

#include <filesystem>

#include "coverage/route/route.h"

namespace swathplan {

/// Writes the whole route as a GeoPackage in the coordinates of the input file. The layer 'legs'
/// has a line for each leg with its kind, number, fan and speed at its start; the layer 'waypoints'
/// has every waypoint with the columns of route.csv, in the order of sailing. The same route gives
/// the same bytes. @throws InvalidInput if the file cannot be written.
void write_route_gpkg(const std::filesystem::path& path, const Route& route, const Frame& frame);

}  // namespace swathplan

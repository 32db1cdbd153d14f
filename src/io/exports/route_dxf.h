#pragma once

#include <filesystem>

#include "coverage/route/route.h"

namespace swathplan {

/// Writes the route as AutoCAD DXF: a polyline for each leg in the coordinates of the input file,
/// in a layer named after its kind (line, turn, transit, ...), at height 0.
/// @throws InvalidInput if the file cannot be written.
void write_route_dxf(const std::filesystem::path& path, const Route& route, const Frame& frame);

}  // namespace swathplan

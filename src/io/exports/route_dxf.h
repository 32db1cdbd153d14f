#pragma once

#include <filesystem>

#include "coverage/route/route.h"

namespace swathplan {

/// Writes the route as AutoCAD DXF. Each leg is a polyline at height 0 in the coordinates of the
/// input file. Its layer is named after the kind of the leg (line, turn, transit, ...).
/// @throws InvalidInput if the file cannot be written.
void write_route_dxf(const std::filesystem::path& path, const Route& route, const Frame& frame);

}  // namespace swathplan

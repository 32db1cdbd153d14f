#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The route as KML 2.2 for map viewers. Each kind of leg has a folder and a colour. Each leg is a
/// line on the surface; its number in the order of sailing is its data `leg`.
[[nodiscard]] std::string route_kml(const GeographicRoute& route, const std::string& name);

}  // namespace swathplan

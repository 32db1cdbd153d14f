#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The route as KML 2.2 for map viewers: a folder for each kind of leg, in it a line for each leg,
/// laid on the surface, in a colour of its kind.
[[nodiscard]] std::string route_kml(const GeographicRoute& route, const std::string& name);

}  // namespace swathplan

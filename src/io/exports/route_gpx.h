#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The route as GPX 1.1: one `rte` called `name`, a `rtept` for each waypoint with its name (see
/// waypoint_names) and, as `type`, the kind of the leg that begins there. GPX routes hold no speed.
[[nodiscard]] std::string route_gpx(const GeographicRoute& route, const std::string& name);

}  // namespace swathplan

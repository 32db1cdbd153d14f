#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The route as GPX 1.1: one `rte` called `name`. Each waypoint is a `rtept` with its name (see
/// short_waypoint_names) and that in full as its description. Its `type` is the kind of the leg
/// that begins there. GPX routes hold no speed.
[[nodiscard]] std::string route_gpx(const GeographicRoute& route, const std::string& name);

}  // namespace swathplan

#pragma once

#include <string>

#include "io/exports/geographic_route.h"

namespace swathplan {

/// The survey lines of a route (see survey_runs) as runlines of EIVA NaviPac: each begins with its
/// name in quotation marks; then easting, northing, kilometres from its start. Coordinates are
/// those of the input file, to a millimetre. A comment, which NaviPac passes over, holds its fan
/// and speed. Turns are left out.
[[nodiscard]] std::string route_rln(const Route& route, const Frame& frame);

/// The survey lines of a route as planned lines of Kongsberg SIS: a row each, with latitudes and
/// longitudes in degrees to 1e-8. The time that SIS asks for is always the same, so that the same
/// route gives the same bytes.
[[nodiscard]] std::string route_asciiplan(const GeographicRoute& route);

}  // namespace swathplan

#pragma once

#include <string>

#include "coverage/route/route.h"

namespace swathplan {

/// The survey lines of a route (see survey_runs) as planned lines of HYPACK. Eastings and northings
/// are those of the input file, to a millimetre. Turns and speeds are left out. Each line of text
/// ends in CRLF.
[[nodiscard]] std::string route_lnw(const Route& route, const Frame& frame);

}  // namespace swathplan

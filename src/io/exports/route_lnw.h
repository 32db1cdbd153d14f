#pragma once

#include <string>

#include "coverage/route/route.h"

namespace swathplan {

/// The survey lines of a route (see survey_runs) as planned lines of HYPACK: eastings and
/// northings of the input file to a millimetre, no turns, no speeds. Lines of the file end in CRLF.
[[nodiscard]] std::string route_lnw(const Route& route, const Frame& frame);

}  // namespace swathplan

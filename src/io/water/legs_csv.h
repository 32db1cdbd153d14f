#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coverage/water/leg_water.h"

namespace swathplan {

/// The legs of a route as CSV (RFC 4180): `leg,line,kind,start_s,end_s,start_time,end_time,
/// least_depth_m,under_keel_m,short_of_water,water_windows`. Times are UTC, empty without a
/// departure; windows are 'from/to' with blanks between them, empty without a tide.
[[nodiscard]] std::string legs_csv(const Route& route, const std::vector<LegWater>& legs,
                                   const std::optional<double>& departure_s);

}  // namespace swathplan

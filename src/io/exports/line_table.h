#pragma once

#include <string>

#include "coverage/route/route.h"

namespace swathplan {

/// What formats of other programs do not hold of survey lines, as CSV (RFC 4180): a row for each
/// stretch of a line, cross line or infill pass with one fan and one speed, in the order of
/// sailing:
/// `line,kind,stretch,start_x_m,start_y_m,end_x_m,end_y_m,start_lon_deg,start_lat_deg,end_lon_deg,
/// end_lat_deg,heading_deg,length_m,port_deg,stbd_deg,speed_mps`.
/// `line` is its name (see survey_runs); `stretch` counts from 1 within it; headings are those of
/// the grid, from the stretch's start to its end; longitudes and latitudes are empty without a CRS.
[[nodiscard]] std::string line_table(const Route& route, const Frame& frame);

}  // namespace swathplan

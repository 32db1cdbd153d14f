#pragma once

#include <string>
#include <string_view>

#include "io/route/foreign_route.h"

namespace swathplan {

/// True for runlines of EIVA NaviPac: behind comments (#) a name alone in quotation marks.
[[nodiscard]] bool is_rln(std::string_view text);
/// Reads them: eastings and northings in the coordinates of the seafloor's file. Kilometres and
/// further columns are passed over. @throws InvalidInput for a broken row, which it names.
[[nodiscard]] ForeignRoute parse_route_rln(std::string_view text, const std::string& file);

/// True for planned lines of Kongsberg SIS: a unit alone in the first row, then rows of _LINE.
[[nodiscard]] bool is_asciiplan(std::string_view text);
/// Reads them, latitudes before longitudes. @throws InvalidInput for another unit than DEG, or a
/// broken row, which it names.
[[nodiscard]] ForeignRoute parse_route_asciiplan(std::string_view text, const std::string& file);

}  // namespace swathplan

#pragma once

#include <string>
#include <string_view>

#include "io/route/foreign_route.h"

namespace swathplan {

/// Reads planned lines of HYPACK (.lnw) in the coordinates of the seafloor's file: each LIN with
/// its PTS is a survey line; its number is taken from LNN.
/// @throws InvalidInput for a broken line of text, which it names.
[[nodiscard]] ForeignRoute parse_route_lnw(std::string_view text, const std::string& file);

/// Reads a drawing (DXF) in the coordinates of the seafloor's file: each line, polyline, arc or
/// curve is a line, in the order of the file; layers that are named after kinds of legs say what
/// they are.
/// @throws InvalidInput if it cannot be read or holds no line.
[[nodiscard]] ForeignRoute parse_route_dxf(std::string_view text, const std::string& file);

}  // namespace swathplan

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace swathplan {

/// '1 turn', '3 turns'; `many` is for words whose plural does more than add an s.
[[nodiscard]] std::string counted(std::size_t count, std::string_view one,
                                  std::string_view many = {});

/// The azimuth of lines sailed both ways, in whole degrees from 0 to 179: 176 for -4.
[[nodiscard]] int axis_degrees(double azimuth_deg);

}  // namespace swathplan

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

/// '93 degrees', or '93 degrees true (90 of the grid)' where the grid's north, whose true azimuth
/// is `grid_north_deg`, is not true north. Of lines sailed both ways.
[[nodiscard]] std::string azimuth_text(double grid_azimuth_deg, double grid_north_deg);

/// The note of a plan whose search was ended after `tried` candidates.
[[nodiscard]] std::string ended_early_note(std::size_t tried, std::string_view one,
                                           std::string_view many = {});

}  // namespace swathplan

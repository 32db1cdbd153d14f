#pragma once

#include <optional>
#include <string_view>

namespace swathplan {

/// Where x, y and z stand in a row of soundings.
struct SoundingColumns {
  std::size_t x = 0, y = 1, z = 2;
  bool z_is_depth = false;  ///< the column is named as a depth: positive down
  bool lon_lat = false;     ///< the columns are named as longitude and latitude
};

/// Finds the columns by their names ('lon_deg', 'Easting (m)', 'depth', ...). Empty if a column for
/// x, y or z is missing.
[[nodiscard]] std::optional<SoundingColumns> named_columns(std::string_view header, char separator);

/// The separator and the decimal sign of rows of numbers.
struct RowStyle {
  char separator = ' ';
  bool decimal_comma = false;
};

/// Finds how a row of at least three numbers is written. Empty if it holds no three numbers.
[[nodiscard]] std::optional<RowStyle> style_of(std::string_view row);

}  // namespace swathplan

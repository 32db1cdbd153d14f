#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// Where x, y and z stand in a row of soundings.
struct SoundingColumns {
  std::size_t x = 0, y = 1, z = 2;
  bool z_is_depth = false;               ///< the column is named as a depth: positive down
  bool lon_lat = false;                  ///< the columns are named as longitude and latitude
  std::optional<double> z_unit_m = {};   ///< metres in one unit of z, where the name says so
  std::optional<double> xy_unit_m = {};  ///< metres in one unit of x and y, where the names say so
  std::vector<std::string> passed_over = {};  ///< names of other columns that could be z
};

/// Finds the columns by their names ('lon_deg', 'Easting (m)', 'POINT_X', 'depth_in_feet', ...).
/// Case, blanks, underscores and units do not count. A depth goes before an elevation, and that
/// before the height or altitude, which may be the antenna's. Empty if a column for x, y or z is
/// missing, or if minutes of an angle have a column of their own.
[[nodiscard]] std::optional<SoundingColumns> named_columns(std::string_view header, char separator);

/// What one column's name says.
struct ColumnName {
  enum class Role { none, x, y, lon, lat, z } role = Role::none;
  bool is_depth = false;              ///< z, positive down
  std::optional<double> unit_m = {};  ///< metres in its unit of length
  bool in_degrees = false;            ///< the name or its unit speaks of degrees
};
[[nodiscard]] ColumnName column_name(std::string_view name);

/// The first word of a text that names a unit of length other than the metre ('feet', 'ft',
/// 'fathoms', 'cm'); empty if none does.
[[nodiscard]] std::string foreign_unit_in(std::string_view text);

/// The columns as a user names them: a number from 1 on, or a name of the header.
struct ColumnChoice {
  std::string x = {}, y = {}, z = {};
  bool lon_lat = false;     ///< said as 'lon' and 'lat'
  bool z_is_depth = false;  ///< said as 'depth'
  [[nodiscard]] bool given() const { return !x.empty(); }
};

/// Reads 'x=3,y=2,z=5', 'x=POINT_X,y=POINT_Y,z=DEPTH' or 'lon=2,lat=1,depth=3'. An empty text makes
/// no choice.
/// @throws UsageError if x, y and z are not each named once.
[[nodiscard]] ColumnChoice parse_columns(std::string_view text);

/// The place (from 0) of a wanted column: its number, or its name among those of the header, alike
/// but for case, blanks and underscores. Empty if there is none.
[[nodiscard]] std::optional<std::size_t> find_column(std::string_view wanted,
                                                     const std::vector<std::string_view>& header);

/// The fields of a row. Quotation marks hold a field together. Views into `row`.
[[nodiscard]] std::vector<std::string_view> split_row(std::string_view row, char separator);

/// The names of a header. A unit in brackets belongs to the name before it. Views into `header`.
[[nodiscard]] std::vector<std::string_view> split_header(std::string_view header, char separator);

/// The separator and the decimal sign of rows of numbers.
struct RowStyle {
  char separator = ' ';
  bool decimal_comma = false;
};

/// Finds how a row of at least three numbers (or angles) is written. Empty if it holds no three.
[[nodiscard]] std::optional<RowStyle> style_of(std::string_view row);

/// The number that a field of such a row spells, 'nan' included; empty if it spells none.
[[nodiscard]] std::optional<double> number_of(std::string_view field, const RowStyle& style);

/// An angle with its hemisphere: '36.5N', 'W 75 30 00', '33:51:12S', 33 degrees 51' 12".
struct FieldAngle {
  double degrees = 0.0;
  char hemisphere = ' ';  ///< 'N', 'S', 'E', 'W' or ' '; the sign is in `degrees`
};
/// Empty if the field is no angle, or a plain number.
[[nodiscard]] std::optional<FieldAngle> angle_of(std::string_view field);

}  // namespace swathplan

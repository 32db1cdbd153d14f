#include "io/seafloor/sounding_columns.h"

#include <algorithm>
#include <array>
#include <string>

#include "io/files/text.h"

namespace swathplan {
namespace {

constexpr std::array<std::string_view, 9> kNamesOfX = {
    "x", "lon", "long", "longitude", "easting", "east", "e", "utm_e", "utmx"};
constexpr std::array<std::string_view, 8> kNamesOfY = {"y",     "lat", "latitude", "northing",
                                                       "north", "n",   "utm_n",    "utmy"};
constexpr std::array<std::string_view, 9> kNamesOfZ = {
    "z", "elevation", "elev", "height", "h", "altitude", "alt", "bed_level", "bathymetry"};
constexpr std::array<std::string_view, 6> kNamesOfDepth = {"depth",       "d",      "dep",
                                                           "water_depth", "depths", "sounding"};

/// 'Depth (m)' -> 'depth', 'lon_deg' -> 'lon'.
std::string plain_name(std::string_view field) {
  std::string name = lower(trim(field.substr(0, field.find_first_of("([{"))));
  std::replace(name.begin(), name.end(), ' ', '_');
  for (const std::string_view unit :
       {"_m", "_deg", "_dd", "_degrees", "_metres", "_meters", "_ft"}) {
    if (name.size() > unit.size() && name.ends_with(unit)) name.erase(name.size() - unit.size());
  }
  return name;
}

template <std::size_t N>
bool among(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool three_numbers(const std::vector<std::string_view>& fields, bool decimal_comma) {
  if (fields.size() < 3) return false;
  return std::all_of(fields.begin(), fields.begin() + 3, [&](std::string_view field) {
    std::string text(field);
    if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
    return to_number(text).has_value();
  });
}

}  // namespace

std::optional<SoundingColumns> named_columns(std::string_view header, char separator) {
  SoundingColumns columns;
  bool has_x = false;
  bool has_y = false;
  bool has_z = false;
  const std::vector<std::string_view> fields = split(header, separator);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = plain_name(fields[i]);
    const bool is_depth = among(kNamesOfDepth, name);
    if (!has_x && among(kNamesOfX, name)) {
      has_x = true;
      columns.x = i;
      columns.lon_lat = name.starts_with("lon");
    } else if (!has_y && among(kNamesOfY, name)) {
      has_y = true;
      columns.y = i;
    } else if (!has_z && (is_depth || among(kNamesOfZ, name))) {
      has_z = true;
      columns.z = i;
      columns.z_is_depth = is_depth;
    }
  }
  if (!has_x || !has_y || !has_z) return {};
  return columns;
}

std::optional<RowStyle> style_of(std::string_view row) {
  constexpr std::array kStyles = {RowStyle{';', false}, RowStyle{';', true},  RowStyle{'\t', false},
                                  RowStyle{',', false}, RowStyle{' ', false}, RowStyle{' ', true}};
  for (const RowStyle& style : kStyles) {
    if (three_numbers(split(row, style.separator), style.decimal_comma)) return style;
  }
  return {};
}

}  // namespace swathplan

#include "io/soundings/sounding_columns.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "io/files/text.h"
#include "io/files/units.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Role = ColumnName::Role;

/// A name without blanks, underscores and units. Of several columns of one role that of the highest
/// rank is taken.
struct KnownName {
  std::string_view word;
  Role role;
  int rank;
  bool is_depth = false;
};

// 'e', 'n', 'd' and 'h' may mean other things. A 'sounding' may be its number. 'height' and
// 'altitude' may be those of the antenna.
constexpr auto kKnownNames = std::to_array<KnownName>({
    {"x", Role::x, 2},
    {"easting", Role::x, 2},
    {"eastings", Role::x, 2},
    {"east", Role::x, 2},
    {"e", Role::x, 1},
    {"este", Role::x, 2},
    {"utme", Role::x, 2},
    {"xutm", Role::x, 2},
    {"rechtswert", Role::x, 2},
    {"y", Role::y, 2},
    {"northing", Role::y, 2},
    {"northings", Role::y, 2},
    {"north", Role::y, 2},
    {"n", Role::y, 1},
    {"norte", Role::y, 2},
    {"utmn", Role::y, 2},
    {"yutm", Role::y, 2},
    {"hochwert", Role::y, 2},
    {"lon", Role::lon, 2},
    {"lng", Role::lon, 2},
    {"long", Role::lon, 2},
    {"longitude", Role::lon, 2},
    {"longitudes", Role::lon, 2},
    {"lat", Role::lat, 2},
    {"latitude", Role::lat, 2},
    {"latitudes", Role::lat, 2},
    {"depth", Role::z, 5, true},
    {"depths", Role::z, 5, true},
    {"dep", Role::z, 5, true},
    {"dpth", Role::z, 5, true},
    {"zdepth", Role::z, 5, true},
    {"depthz", Role::z, 5, true},
    {"depthvalue", Role::z, 5, true},
    {"valsou", Role::z, 5, true},
    {"tiefe", Role::z, 5, true},
    {"profondeur", Role::z, 5, true},
    {"profundidad", Role::z, 5, true},
    {"prof", Role::z, 5, true},
    {"z", Role::z, 4},
    {"zvalue", Role::z, 4},
    {"elevation", Role::z, 4},
    {"elevations", Role::z, 4},
    {"elev", Role::z, 4},
    {"ele", Role::z, 4},
    {"bedlevel", Role::z, 4},
    {"bathymetry", Role::z, 4},
    {"bathy", Role::z, 4},
    {"sounding", Role::z, 3, true},
    {"soundings", Role::z, 3, true},
    {"d", Role::z, 3, true},
    {"height", Role::z, 2},
    {"heights", Role::z, 2},
    {"altitude", Role::z, 2},
    {"alt", Role::z, 2},
    {"h", Role::z, 1},
});

/// Words beside a name that do not change what it means.
constexpr auto kBesideNames = std::to_array<std::string_view>(
    {"point",    "pt",    "coord",     "coords",    "coordinate", "coordinates", "pos",
     "position", "utm",   "wgs84",     "wgs",       "nad83",      "gps",         "map",
     "grid",     "proj",  "projected", "decimal",   "dec",        "water",       "corrected",
     "corr",     "mean",  "avg",       "average",   "bottom",     "seafloor",    "seabed",
     "bed",      "total", "final",     "processed", "measured",   "in",          "mllw",
     "mlw",      "msl",   "navd88",    "navd",      "igld85",     "chart",       "datum",
     "value"});

constexpr auto kDegrees = std::to_array<std::string_view>(
    {"deg", "degs", "degree", "degrees", "dd", "decdeg", "decimal degrees", "degrees east",
     "degrees north", "degree east", "degree north", "\xC2\xB0",
     "\xC2\xB0"
     "e",
     "\xC2\xB0"
     "n"});

/// Units that stand at a name's end without a gap: 'depthft'.
constexpr auto kGluedUnits = std::to_array<std::string_view>(
    {"usft", "ftus", "metres", "meters", "metre", "meter", "feet", "foot", "ft", "fathoms",
     "fathom", "fm", "degrees", "deg", "dd", "cm", "m"});

template <class Words>
bool among(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

const KnownName* known(std::string_view word) {
  const auto* const found = std::find_if(kKnownNames.begin(), kKnownNames.end(),
                                         [&](const KnownName& n) { return n.word == word; });
  return found == kKnownNames.end() ? nullptr : found;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 128;
}

std::string joined(const std::vector<std::string>& words, const char* between = "") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : lower(text) + " ") {
    if (is_letter(c)) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  return words;
}

/// Takes `text` as a unit: of length or degrees. False if it is none.
bool take_unit(const std::string& text, ColumnName& name) {
  std::optional<double> unit_m = metres_in(text);
  if (!unit_m && (text == "us survey ft" || text == "survey ft" || text == "sft")) {
    unit_m = metres_in("us survey foot");
  }
  if (!unit_m && (text == "intl ft" || text == "international ft")) unit_m = metres_in("foot");
  if (!unit_m && text == "fms") unit_m = metres_in("fathom");
  const bool in_degrees = among(kDegrees, text);
  if (unit_m && !name.unit_m) name.unit_m = unit_m;
  name.in_degrees = name.in_degrees || in_degrees;
  return unit_m || in_degrees;
}

/// Takes the units in brackets; returns the name without brackets.
std::string without_brackets(std::string_view field, ColumnName& name) {
  std::string rest(field);
  for (std::size_t open; (open = rest.find_first_of("([{")) != std::string::npos;) {
    const std::size_t close = std::min(rest.find_first_of(")]}", open), rest.size());
    const std::vector<std::string> words =
        words_of(std::string_view(rest).substr(open + 1, close - open - 1));
    if (!take_unit(joined(words, " "), name)) {
      bool found = false;
      for (std::size_t n = 2; n >= 1; --n) {
        for (std::size_t i = 0; i + n <= words.size() && !found; ++i) {
          found = take_unit(joined({words.begin() + static_cast<std::ptrdiff_t>(i),
                                    words.begin() + static_cast<std::ptrdiff_t>(i + n)},
                                   " "),
                            name);
        }
      }
    }
    rest.replace(open, std::min(close + 1, rest.size()) - open, " ");
  }
  return rest;
}

/// Takes a unit of up to three words off the end.
bool take_last_unit(std::vector<std::string>& words, ColumnName& name) {
  for (std::size_t n = std::min<std::size_t>(3, words.size() - 1); n >= 1; --n) {
    const auto first = words.end() - static_cast<std::ptrdiff_t>(n);
    if (!take_unit(joined({first, words.end()}, " "), name)) continue;
    words.erase(first, words.end());
    return true;
  }
  return false;
}

/// 'correcteddepth' -> 'depth', 'depthft' -> 'depth' and feet. Null if nothing known is left.
const KnownName* known_inside(std::string_view word, ColumnName& name) {
  if (const KnownName* found = known(word)) return found;
  for (const std::string_view beside : kBesideNames) {
    if (beside.size() >= word.size() || beside.size() < 3) continue;
    if (word.starts_with(beside)) {
      if (const KnownName* found = known(word.substr(beside.size()))) return found;
    }
    if (word.ends_with(beside)) {
      if (const KnownName* found = known(word.substr(0, word.size() - beside.size()))) return found;
    }
  }
  for (const std::string_view unit : kGluedUnits) {
    if (unit.size() >= word.size() || !word.ends_with(unit)) continue;
    const std::string_view rest = word.substr(0, word.size() - unit.size());
    const KnownName* found = known(rest);
    const bool sure = rest.size() > 1 || rest == "x" || rest == "y" || rest == "z";
    if (found == nullptr || !sure || !take_unit(std::string(unit), name)) continue;
    return found;
  }
  return nullptr;
}

struct RankedName {
  ColumnName name;
  int rank = 0;
};

RankedName ranked_name(std::string_view field) {
  RankedName result;
  std::vector<std::string> words = words_of(without_brackets(field, result.name));
  const KnownName* found = nullptr;
  while (!words.empty()) {
    found = known_inside(joined(words), result.name);
    if (found != nullptr || words.size() == 1) break;
    if (take_last_unit(words, result.name)) continue;
    if (among(kBesideNames, words.back())) {
      words.pop_back();
    } else if (among(kBesideNames, words.front())) {
      words.erase(words.begin());
    } else {
      break;
    }
  }
  if (found == nullptr) return result;
  result.name.role = found->role;
  result.name.is_depth = found->is_depth;
  if (found->role == Role::lon || found->role == Role::lat) result.name.in_degrees = true;
  result.rank = found->rank;
  return result;
}

/// 'lat_min' beside 'lat_deg': degrees and minutes have a column each.
bool is_part_of_angle(std::string_view field) {
  constexpr auto kParts = std::to_array<std::string_view>(
      {"min", "mins", "minute", "minutes", "sec", "secs", "second", "seconds"});
  constexpr auto kGlued =
      std::to_array<std::string_view>({"latmin", "lonmin", "longmin", "latsec", "lonsec", "longsec",
                                       "latminutes", "lonminutes", "latseconds", "lonseconds"});
  const std::vector<std::string> words = words_of(field);
  const bool part = std::any_of(words.begin(), words.end(),
                                [&](const std::string& w) { return among(kParts, w); });
  const bool angle = std::any_of(words.begin(), words.end(), [](const std::string& w) {
    const KnownName* name = known(w);
    return name != nullptr && (name->role == Role::lon || name->role == Role::lat);
  });
  return (part && angle) || among(kGlued, joined(words));
}

/// The first column of the highest rank; empty if there is none.
struct Best {
  std::optional<std::size_t> at;
  int rank = 0;
  void offer(std::size_t i, int r) {
    if (at && r <= rank) return;
    at = i;
    rank = r;
  }
};

}  // namespace

ColumnName column_name(std::string_view name) { return ranked_name(name).name; }

std::string foreign_unit_in(std::string_view text) {
  constexpr auto kUnits = std::to_array<std::string_view>(
      {"feet", "foot", "ft", "usft", "ftus", "sft", "fathom", "fathoms", "fms", "cm", "centimetres",
       "centimeters", "dm", "decimetres", "decimeters", "mm", "millimetres", "millimeters"});
  for (const std::string& word : words_of(text)) {
    if (among(kUnits, word)) return word;
  }
  return {};
}

std::optional<SoundingColumns> named_columns(std::string_view header, char separator) {
  const std::vector<std::string_view> fields = split_header(header, separator);
  std::vector<RankedName> names;
  Best x, y, lon, lat, z;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (is_part_of_angle(fields[i])) return {};
    names.push_back(ranked_name(fields[i]));
    switch (names.back().name.role) {
      case Role::x:
        x.offer(i, names.back().rank);
        break;
      case Role::y:
        y.offer(i, names.back().rank);
        break;
      case Role::lon:
        lon.offer(i, names.back().rank);
        break;
      case Role::lat:
        lat.offer(i, names.back().rank);
        break;
      case Role::z:
        z.offer(i, names.back().rank);
        break;
      case Role::none:
        break;
    }
  }
  const bool map = x.at && y.at;
  const bool degrees = lon.at && lat.at;
  if (!z.at || (!map && !degrees)) return {};
  SoundingColumns columns;
  columns.lon_lat = degrees && (!map || *lon.at < *x.at);
  columns.x = columns.lon_lat ? *lon.at : *x.at;
  columns.y = columns.lon_lat ? *lat.at : *y.at;
  columns.z = *z.at;
  const ColumnName& east = names[columns.x].name;
  const ColumnName& north = names[columns.y].name;
  if (east.in_degrees && north.in_degrees) columns.lon_lat = true;
  if (!columns.lon_lat && east.unit_m == north.unit_m) columns.xy_unit_m = east.unit_m;
  columns.z_is_depth = names[columns.z].name.is_depth;
  columns.z_unit_m = names[columns.z].name.unit_m;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i != columns.z && names[i].name.role == Role::z) {
      columns.passed_over.emplace_back(fields[i]);
    }
  }
  return columns;
}

ColumnChoice parse_columns(std::string_view text) {
  ColumnChoice choice;
  if (trim(text).empty()) return choice;
  const auto refuse = [&]() -> UsageError {
    return {"columns", std::string(text),
            "must name x, y and z once each, by number or by name, as in x=3,y=2,z=5 or "
            "x=POINT_X,y=POINT_Y,z=DEPTH"};
  };
  bool lon = false;
  bool lat = false;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) throw refuse();
    const ColumnName key = column_name(trim(part.substr(0, equals)));
    const std::string_view value = trim(part.substr(equals + 1));
    std::string* axis = nullptr;
    if (key.role == Role::x || key.role == Role::lon) axis = &choice.x;
    if (key.role == Role::y || key.role == Role::lat) axis = &choice.y;
    if (key.role == Role::z) axis = &choice.z;
    const std::optional<double> number = to_number(value);
    const bool bad_number =
        number && !(*number >= 1.0 && *number <= 1e6 && std::floor(*number) == *number);
    if (axis == nullptr || !axis->empty() || value.empty() || bad_number) throw refuse();
    *axis = value;
    lon = lon || key.role == Role::lon;
    lat = lat || key.role == Role::lat;
    choice.z_is_depth = choice.z_is_depth || key.is_depth;
  }
  if (choice.x.empty() || choice.y.empty() || choice.z.empty() || lon != lat) throw refuse();
  if (choice.x == choice.y || choice.x == choice.z || choice.y == choice.z) throw refuse();
  choice.lon_lat = lon;
  return choice;
}

std::optional<std::size_t> find_column(std::string_view wanted,
                                       const std::vector<std::string_view>& header) {
  if (const std::optional<double> number = to_number(wanted)) {
    return static_cast<std::size_t>(*number) - 1;
  }
  const std::string exact = lower(trim(wanted));
  const std::string loose = joined(words_of(wanted));
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (lower(trim(header[i])) == exact) return i;
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!loose.empty() && joined(words_of(header[i])) == loose) return i;
  }
  return {};
}

std::vector<std::string_view> split_row(std::string_view row, char separator) {
  if (row.find('"') == std::string_view::npos) return split(row, separator);
  const auto parts = [&](char c) {
    return separator == ' ' ? c == ' ' || c == '\t' : c == separator;
  };
  std::vector<std::string_view> fields;
  std::size_t first = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= row.size(); ++i) {
    if (i < row.size() && row[i] == '"') quoted = !quoted;
    if (i < row.size() && (quoted || !parts(row[i]))) continue;
    std::string_view field = trim(row.substr(first, i - first));
    first = i + 1;
    if (separator == ' ' && field.empty()) continue;
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') {
      field = trim(field.substr(1, field.size() - 2));
    }
    fields.push_back(field);
  }
  return fields;
}

std::vector<std::string_view> split_header(std::string_view header, char separator) {
  std::vector<std::string_view> fields = split_row(header, separator);
  if (separator != ' ') return fields;
  std::vector<std::string_view> names;
  for (const std::string_view field : fields) {
    const bool opens = field.find_first_of("([{") == 0;
    const bool inside = !names.empty() &&
                        names.back().find_first_of("([{") != std::string_view::npos &&
                        names.back().find_first_of(")]}") == std::string_view::npos;
    if (!names.empty() && (opens || inside)) {
      const char* begin = names.back().data();
      names.back() = {begin, static_cast<std::size_t>(field.data() + field.size() - begin)};
    } else {
      names.push_back(field);
    }
  }
  return names;
}

std::optional<double> number_of(std::string_view field, const RowStyle& style) {
  const std::optional<double> plain = to_number(field);
  if (plain || style.separator == ',' || field.find(',') == std::string_view::npos) return plain;
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return to_number(text);
}

std::optional<RowStyle> style_of(std::string_view row) {
  constexpr std::array kStyles = {RowStyle{';', false}, RowStyle{';', true},  RowStyle{'\t', false},
                                  RowStyle{'\t', true}, RowStyle{',', false}, RowStyle{' ', false},
                                  RowStyle{' ', true}};
  for (const bool angles : {false, true}) {
    for (const RowStyle& style : kStyles) {
      const std::vector<std::string_view> fields = split_row(row, style.separator);
      const auto numbers = std::count_if(fields.begin(), fields.end(), [&](std::string_view f) {
        const bool number =
            style.decimal_comma ? number_of(f, style).has_value() : to_number(f).has_value();
        return number || (angles && angle_of(f).has_value());
      });
      if (numbers >= 3) return style;
    }
  }
  return {};
}

std::optional<FieldAngle> angle_of(std::string_view field) {
  if (to_number(field)) return {};
  FieldAngle angle;
  std::array<double, 3> parts{};
  std::size_t count = 0;
  bool negative = false;
  for (std::size_t i = 0; i < field.size();) {
    const char c = field[i];
    if (c >= '0' && c <= '9') {
      if (count == parts.size()) return {};
      const char* begin = field.data() + i;
      const auto [end, error] = std::from_chars(begin, field.data() + field.size(), parts.at(count),
                                                std::chars_format::fixed);
      if (error != std::errc()) return {};
      ++count;
      i += static_cast<std::size_t>(end - begin);
      continue;
    }
    // A small 's' closes the seconds.
    const bool small = c == 'n' || c == 'e' || c == 'w';
    const char upper = small ? static_cast<char>(c - 'a' + 'A') : c;
    if (std::string_view("NSEW").find(upper) != std::string_view::npos) {
      const bool at_end = i == 0 || i + 1 == field.size();
      if (!at_end || angle.hemisphere != ' ') return {};
      angle.hemisphere = upper;
    } else if (c == '-' || c == '+') {
      if (count > 0) return {};
      negative = c == '-';
    } else {
      // A blank, a colon, the signs of degrees, minutes and seconds (one or more bytes each).
      const bool sign = c == ' ' || c == ':' || c == '\'' || c == '"' || c == 'd' || c == 'm' ||
                        (c == 's' && count == 3) || static_cast<unsigned char>(c) >= 128;
      if (!sign) return {};
    }
    ++i;
  }
  if (count == 0 || (count == 1 && angle.hemisphere == ' ')) return {};
  if (parts[1] >= 60.0 || parts[2] >= 60.0 || (negative && angle.hemisphere != ' ')) return {};
  angle.degrees = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
  if (negative || angle.hemisphere == 'S' || angle.hemisphere == 'W') angle.degrees *= -1.0;
  return angle;
}

}  // namespace swathplan

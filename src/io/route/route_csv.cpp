#include "io/route/route_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/files/atomic_file.h"
#include "io/files/csv.h"
#include "io/files/lonlat.h"
#include "io/files/text.h"
#include "io/files/units.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

constexpr const char* kInfeasible = "infeasible";
constexpr int kMicrometre = 6;    // decimals of a metre
constexpr int kLonLatDigits = 9;  // decimals of a degree: 0.1 mm
constexpr int kAngleDigits = 6;   // decimals of a degree: 2 mm at 100 km

std::string row(std::size_t seq, const Waypoint& w, const Vec2& file, const Vec2* lonlat) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", seq,
                     w.line ? std::to_string(*w.line) : "", name(w.kind), w.log ? 1 : 0,
                     decimal(file.x(), kMicrometre), decimal(file.y(), kMicrometre),
                     lonlat != nullptr ? decimal(lonlat->x(), kLonLatDigits) : "",
                     lonlat != nullptr ? decimal(lonlat->y(), kLonLatDigits) : "",
                     w.fan ? decimal(w.fan->port.deg(), kAngleDigits) : "",
                     w.fan ? decimal(w.fan->starboard.deg(), kAngleDigits) : "", w.speed_mps,
                     w.region ? std::to_string(*w.region) : "", w.feasible ? "" : kInfeasible);
}

/// Spreadsheets of many countries write '450002,6'. Where a comma can be in a field at all, another
/// sign or quotation marks part the fields.
std::optional<double> with_decimal_comma(std::string text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find('.') != std::string::npos) return std::nullopt;
  text[comma] = '.';
  return to_finite_number(text);
}

/// Reads rows of a table by the names of their columns.
class Columns {
 public:
  Columns(const CsvTable& table, std::string file) : table_(table), file_(std::move(file)) {}

  /// The first of the names that is a column.
  [[nodiscard]] std::optional<std::size_t> find(std::initializer_list<const char*> names) const {
    for (const char* n : names) {
      const auto at = std::find(table_.header.begin(), table_.header.end(), n);
      if (at != table_.header.end()) return static_cast<std::size_t>(at - table_.header.begin());
    }
    return std::nullopt;
  }

  /// The field of a row; empty where there is no such column.
  [[nodiscard]] std::string_view text(const CsvTable::Row& row,
                                      std::optional<std::size_t> column) const {
    return column ? std::string_view(row.fields[*column]) : std::string_view();
  }

  /// @throws InvalidInput unless the field is a finite number.
  [[nodiscard]] double number(const CsvTable::Row& row, std::size_t column) const {
    const std::string& text = row.fields[column];
    auto value = to_finite_number(text);
    if (!value) value = with_decimal_comma(text);
    if (!value) fail(row, column, "is not a finite number");
    return *value;
  }

  /// Empty for an empty field. @throws InvalidInput unless it is a whole number.
  [[nodiscard]] std::optional<int> whole(const CsvTable::Row& row,
                                         std::optional<std::size_t> column) const {
    if (text(row, column).empty()) return std::nullopt;
    const double value = number(row, *column);
    if (value != std::floor(value) || std::abs(value) > 1e9) {
      fail(row, *column, "is not a whole number");
    }
    return static_cast<int>(value);
  }

  [[noreturn]] void fail(const CsvTable::Row& row, std::size_t column, const char* what) const {
    throw InvalidInput(fmt::format("'{}', line {}: {} '{}' {}", file_, row.line,
                                   table_.header[column], row.fields[column], what));
  }

 private:
  const CsvTable& table_;
  std::string file_;
};

struct RouteColumns {
  std::optional<std::size_t> seq, line, kind, log, x, y, lon, lat, port, stbd, speed, region,
      status;
};

RouteColumns route_columns(const Columns& c) {
  return {.seq = c.find({"seq"}),
          .line = c.find({"line"}),
          .kind = c.find({"kind"}),
          .log = c.find({"log"}),
          .x = c.find({"x_m", "x", "easting", "easting_m", "x_ft", "x_us_ft", "x_crs"}),
          .y = c.find({"y_m", "y", "northing", "northing_m", "y_ft", "y_us_ft", "y_crs"}),
          .lon = c.find({"lon_deg", "lon", "longitude", "long", "lng"}),
          .lat = c.find({"lat_deg", "lat", "latitude"}),
          .port = c.find({"port_deg"}),
          .stbd = c.find({"stbd_deg"}),
          .speed = c.find({"speed_mps"}),
          .region = c.find({"region"}),
          .status = c.find({"status"})};
}

std::optional<FanAngles> fan_of(const CsvTable::Row& row, const Columns& c,
                                const RouteColumns& columns) {
  const bool port = !c.text(row, columns.port).empty();
  const bool stbd = !c.text(row, columns.stbd).empty();
  if (!port && !stbd) return std::nullopt;
  if (port != stbd) {
    c.fail(row, port ? *columns.stbd : *columns.port,
           "is missing: give both half-angles, or neither where the sonar is off");
  }
  std::array<double, 2> degrees{};
  for (const std::size_t side : {0U, 1U}) {
    const std::size_t column = side == 0 ? *columns.port : *columns.stbd;
    degrees[side] = c.number(row, column);
    if (degrees[side] <= 0.0 || degrees[side] >= 90.0) {
      c.fail(row, column, "must lie between 0 and 90 degrees, both excluded");
    }
  }
  return FanAngles{.port = Angle::degrees(degrees[0]), .starboard = Angle::degrees(degrees[1])};
}

LegKind kind_of(const CsvTable::Row& row, bool last, const Columns& c,
                const RouteColumns& columns) {
  const std::string_view text = c.text(row, columns.kind);
  if (text.empty()) return last ? LegKind::end : LegKind::line;
  const auto kind = leg_kind(lower(text));
  if (!kind) {
    c.fail(row, *columns.kind,
           "is none of line, turn, transit, cross, infill, patch, run_in, run_out, end");
  }
  if (*kind == LegKind::end && !last) {
    c.fail(row, *columns.kind, "may stand in the last row only");
  }
  return last ? LegKind::end : *kind;
}

bool log_of(const CsvTable::Row& row, const Columns& c, const RouteColumns& columns) {
  const std::string text = lower(c.text(row, columns.log));
  if (text.empty() || text == "1" || text == "true") return true;
  if (text != "0" && text != "false") c.fail(row, *columns.log, "must be 0 or 1");
  return false;
}

double speed_of(const CsvTable::Row& row, const Columns& c, const RouteColumns& columns,
                double otherwise) {
  if (c.text(row, columns.speed).empty()) return otherwise;
  const double speed = c.number(row, *columns.speed);
  if (speed <= 0.0) c.fail(row, *columns.speed, "must be greater than 0");
  return speed;
}

/// What the name of a column says of its unit; empty where it says nothing.
std::string_view mark_in(std::string_view name) {
  const std::size_t at = name.find('_');
  return at == std::string_view::npos ? std::string_view() : name.substr(at + 1);
}

/// Refuses x and y in other units than those of the coordinates that they are to be.
void check_unit(const std::string& name, const std::string& file, const Frame& frame) {
  const std::string_view said = mark_in(name);
  const std::string_view here = unit_mark(frame.metres_per_unit);
  if (said.empty() || said == here) return;
  throw InvalidInput(fmt::format(
      "'{}': the column '{}' does not fit the coordinates of the seafloor's file, whose "
      "columns are x_{},y_{}: convert it, or leave the unit out of its name if the "
      "numbers are such coordinates",
      file, name, here, here));
}

/// Checks the columns of the file before any row is read.
void check_table(const CsvTable& table, const RouteColumns& columns, const std::string& file,
                 const Frame& frame, const RouteDefaults& defaults) {
  const bool xy = columns.x && columns.y;
  if (!xy && !(columns.lon && columns.lat)) {
    throw InvalidInput(fmt::format(
        "'{}' is not a route: its first line must name the columns x_m,y_m or lon_deg,lat_deg "
        "(see route.csv), or the file must be GeoJSON",
        file));
  }
  if (xy) check_unit(table.header[*columns.x], file, frame);
  if (!xy && frame.crs_wkt.empty()) {
    throw InvalidInput(
        fmt::format("'{}' is in longitude and latitude, but the seafloor has no "
                    "CRS: give it with <CRS> EPSG:n",
                    file));
  }
  if (columns.port.has_value() != columns.stbd.has_value()) {
    throw InvalidInput(
        fmt::format("'{}' has only one of the columns port_deg and stbd_deg: "
                    "give both or neither",
                    file));
  }
  if (!columns.port && !defaults.fan) {
    throw InvalidInput(
        fmt::format("'{}' has no columns port_deg,stbd_deg: add them or give the "
                    "opening angle of the fan",
                    file));
  }
  if (table.rows.size() < 2) {
    throw InvalidInput(fmt::format("'{}' has {} waypoint{}: a route needs at least two", file,
                                   table.rows.size(), table.rows.size() == 1 ? "" : "s"));
  }
}

void check_row(const CsvTable::Row& row, const CsvTable& table, const std::string& file) {
  if (row.fields.size() != table.header.size()) {
    throw InvalidInput(fmt::format("'{}', line {}: has {} fields where the first line names {}",
                                   file, row.line, row.fields.size(), table.header.size()));
  }
}

/// Checks that `seq` grows. Rows in another order would make a route that nobody planned.
void check_order(const CsvTable& table, const Columns& c, const RouteColumns& columns) {
  if (!columns.seq) return;
  std::optional<double> before;
  for (const CsvTable::Row& row : table.rows) {
    const double seq = c.number(row, *columns.seq);
    if (before && seq <= *before) {
      c.fail(row, *columns.seq, "does not follow the row before: sort the rows by seq");
    }
    before = seq;
  }
}

std::vector<Vec2> read_positions(const CsvTable& table, const Columns& c,
                                 const RouteColumns& columns, const Frame& frame) {
  const bool xy = columns.x && columns.y;
  std::vector<Vec2> points;
  for (const CsvTable::Row& row : table.rows) {
    points.emplace_back(c.number(row, xy ? *columns.x : *columns.lon),
                        c.number(row, xy ? *columns.y : *columns.lat));
    if (xy) {
      points.back() = frame.to_local(points.back());
    } else if (std::abs(points.back().x()) > 360.0) {
      c.fail(row, *columns.lon, "is no longitude in degrees");
    } else if (std::abs(points.back().y()) > 90.0) {
      c.fail(row, *columns.lat, "is no latitude in degrees");
    }
  }
  return xy ? points : LonLat(frame).to_local(points);
}

void add_notes(ImportedRoute& imported, const RouteColumns& columns, const CsvTable& table,
               const RouteDefaults& defaults) {
  if (!columns.port) {
    imported.fan_note = fmt::format(
        "the route names no fan: {} degrees to port and {} to starboard were taken for all of it",
        decimal(defaults.fan->port.deg(), 2), decimal(defaults.fan->starboard.deg(), 2));
  }
  if (!columns.kind)
    imported.leg_notes.emplace_back("the route names no kinds: all of it is one line");
  if (!columns.speed) {
    imported.leg_notes.push_back(
        fmt::format("the route names no speed: {} m/s was taken", defaults.speed_mps));
  }
  const std::string last = columns.kind ? lower(table.rows.back().fields[*columns.kind]) : "end";
  if (last != "end") {
    imported.notes.push_back(
        fmt::format("the last row is of kind '{}', not end: nothing follows it", last));
  }
}

}  // namespace

std::string route_csv(const Route& route, const Frame& frame) {
  const std::vector<Vec2> local = positions(route.waypoints);
  const LonLat conversion(frame);
  const std::vector<Vec2> lonlat =
      conversion.known() ? conversion.from_local(local) : std::vector<Vec2>();
  std::string text = fmt::format(
      "seq,line,kind,log,x_{0},y_{0},lon_deg,lat_deg,port_deg,stbd_deg,speed_mps,region,status\r\n",
      unit_mark(frame.metres_per_unit));
  for (std::size_t i = 0; i < local.size(); ++i) {
    text +=
        row(i, route.waypoints[i], frame.to_file(local[i]), lonlat.empty() ? nullptr : &lonlat[i]);
  }
  return text;
}

void write_route_csv(const std::filesystem::path& path, const Route& route, const Frame& frame) {
  if (const auto why = fault(route)) throw InvalidInput("the route cannot be written: " + *why);
  write_text_atomically(path, route_csv(route, frame));
}

double route_csv_unit_m(std::string_view text) {
  for (const std::string& name : parse_csv(text).header) {
    if (!name.starts_with("x_")) continue;
    if (const auto metres = metres_of_mark(mark_in(name))) return *metres;
  }
  return 1.0;
}

ImportedRoute parse_route_csv(std::string_view text, const std::string& name, const Frame& frame,
                              const RouteDefaults& defaults) {
  const CsvTable table = parse_csv(text);
  const Columns c(table, name);
  const RouteColumns columns = route_columns(c);
  check_table(table, columns, name, frame, defaults);
  for (const CsvTable::Row& row : table.rows) check_row(row, table, name);
  check_order(table, c, columns);
  const std::vector<Vec2> points = read_positions(table, c, columns, frame);
  ImportedRoute imported;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CsvTable::Row& row = table.rows[i];
    imported.route.waypoints.push_back(
        {.position = points[i],
         .kind = kind_of(row, i + 1 == points.size(), c, columns),
         .log = log_of(row, c, columns),
         .line = c.whole(row, columns.line),
         .fan = columns.port ? fan_of(row, c, columns) : defaults.fan,
         .speed_mps = speed_of(row, c, columns, defaults.speed_mps),
         .region = c.whole(row, columns.region),
         // Another program may use the column for something else.
         .feasible = lower(c.text(row, columns.status)) != kInfeasible});
  }
  add_notes(imported, columns, table, defaults);
  if (const auto why = fault(imported.route)) {
    throw InvalidInput(fmt::format("'{}' is not a valid route: {}", name, *why));
  }
  return imported;
}

}  // namespace swathplan

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/lonlat.h"
#include "io/files/text.h"
#include "io/route/foreign_route.h"
#include "io/route/route_geojson.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using Json = nlohmann::json;

/// A line of the file with the properties of its feature.
struct NamedLine {
  std::string label;  ///< for messages
  std::vector<Vec2> points;
  Json properties;
};

/// Collects the lines of a document in its order.
class LineReader {
 public:
  explicit LineReader(std::string file) : file_(std::move(file)) {}

  void read(const Json& node, const Json& properties, const std::string& label, int depth = 0) {
    constexpr int kMostDepth = 50;
    if (depth > kMostDepth) fail("GeoJSON", "its collections are nested too deeply");
    const std::string type = node.is_object() ? node.value("type", std::string()) : std::string();
    if (type == "FeatureCollection") {
      each(node, "features", [&](const Json& f, std::size_t i) {
        read(f, Json::object(), fmt::format("feature {}", i), depth + 1);
      });
    } else if (type == "Feature") {
      const Json own = node.value("properties", Json());
      const Json geometry = node.value("geometry", Json());
      if (!geometry.is_null())
        read(geometry, own.is_object() ? own : Json::object(), label, depth + 1);
    } else if (type == "GeometryCollection") {
      each(node, "geometries",
           [&](const Json& g, std::size_t) { read(g, properties, label, depth + 1); });
    } else if (type == "LineString") {
      add(node, "coordinates", properties, label);
    } else if (type == "MultiLineString") {
      each(node, "coordinates", [&](const Json& part, std::size_t i) {
        add_points(part, properties, fmt::format("{}, part {}", label, i));
      });
    } else if (type == "Point") {
      add_place(node, label);
    } else if (type == "MultiPoint") {
      each(node, "coordinates", [&](const Json& place, std::size_t i) {
        places_.points.push_back(point(place, fmt::format("{}, point {}", label, i), i));
      });
    } else if (type.empty()) {
      fail(label, "is not GeoJSON: it has no 'type'");
    } else {
      ++others_;
    }
  }

  [[nodiscard]] std::vector<NamedLine>& lines() { return lines_; }
  [[nodiscard]] std::size_t others() const { return others_; }

  /// Points count where no line does: they are waypoints in their order. True if they do.
  bool join_places() {
    if (!lines_.empty()) {
      others_ += places_.points.size();
      return false;
    }
    if (places_.points.size() < 2) return false;
    lines_.push_back(std::move(places_));
    return true;
  }

  [[noreturn]] void fail(const std::string& label, const std::string& what) const {
    throw InvalidInput(fmt::format("'{}', {}: {}", file_, label, what));
  }

 private:
  template <class Use>
  void each(const Json& node, const char* member, Use use) const {
    const auto list = node.find(member);
    if (list == node.end() || !list->is_array()) {
      fail("GeoJSON", fmt::format("'{}' is missing or no list", member));
    }
    for (std::size_t i = 0; i < list->size(); ++i) use((*list)[i], i);
  }

  void add(const Json& node, const char* member, const Json& properties, const std::string& label) {
    const auto list = node.find(member);
    if (list == node.end()) fail(label, "has no coordinates");
    add_points(*list, properties, label);
  }

  void add_place(const Json& node, const std::string& label) {
    const auto place = node.find("coordinates");
    if (place == node.end()) fail(label, "has no coordinates");
    places_.points.push_back(point(*place, label, 0));
  }

  [[nodiscard]] Vec2 point(const Json& p, const std::string& label, std::size_t i) const {
    if (!p.is_array() || p.size() < 2 || !p[0].is_number() || !p[1].is_number()) {
      fail(label, fmt::format("point {} is not a pair of numbers", i));
    }
    return {p[0].get<double>(), p[1].get<double>()};
  }

  void add_points(const Json& list, const Json& properties, const std::string& label) {
    if (!list.is_array() || list.size() < 2) {
      fail(label, "a line needs at least two points");
    }
    NamedLine line{.label = label, .points = {}, .properties = properties};
    for (std::size_t i = 0; i < list.size(); ++i) {
      line.points.push_back(point(list[i], label, i));
    }
    lines_.push_back(std::move(line));
  }

  std::string file_;
  std::vector<NamedLine> lines_;
  NamedLine places_{.label = "its points", .points = {}, .properties = Json::object()};
  std::size_t others_ = 0;
};

/// Where the coordinates of a document lie.
enum class Coordinates { lonlat, seafloor_file, other_crs };

Coordinates coordinates_of(const Json& document) {
  if (document.contains("local_frame")) return Coordinates::seafloor_file;
  return document.contains("crs") && document["crs"].is_object() ? Coordinates::other_crs
                                                                 : Coordinates::lonlat;
}

std::string stated_crs(const Json& document) {
  const Json properties = document["crs"].value("properties", Json::object());
  return properties.is_object() ? properties.value("name", std::string()) : std::string();
}

/// Turns the points of all lines into local metres.
class PointPlacer {
 public:
  PointPlacer(const Json& document, const std::string& file, const Frame& frame)
      : frame_(frame), file_(file), kind_(coordinates_of(document)) {
    if (kind_ == Coordinates::seafloor_file) return;
    if (frame.crs_wkt.empty()) {
      throw InvalidInput(fmt::format(
          "'{}' is in {}, but the seafloor has no CRS: give it with <CRS> EPSG:n, or give the "
          "route in the seafloor's own coordinates with a member \"local_frame\": {{}}",
          file, kind_ == Coordinates::lonlat ? "longitude and latitude" : stated_crs(document)));
    }
    transform_.emplace(kind_ == Coordinates::lonlat ? wgs84_crs() : other_crs(document),
                       frame.crs_wkt);
  }

  void place(NamedLine& line) const {
    if (kind_ == Coordinates::lonlat) check_degrees(line);
    if (transform_) line.points = (*transform_)(line.points);
    for (Vec2& p : line.points) p = frame_.to_local(p);
  }

 private:
  [[nodiscard]] std::string other_crs(const Json& document) const {
    try {
      return parse_crs(stated_crs(document));
    } catch (const UsageError&) {
      throw InvalidInput(fmt::format(
          "'{}': its member 'crs' names no coordinate reference system that can be read ('{}')",
          file_, stated_crs(document)));
    }
  }

  void check_degrees(const NamedLine& line) const {
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (std::abs(line.points[i].x()) > 360.0 || std::abs(line.points[i].y()) > 90.0) {
        throw InvalidInput(fmt::format(
            "'{}', {}: point {} ({}, {}) is no longitude and latitude in degrees; state the 'crs' "
            "of the file",
            file_, line.label, i, line.points[i].x(), line.points[i].y()));
      }
    }
  }

  Frame frame_;
  std::string file_;
  Coordinates kind_;
  std::optional<CrsTransform> transform_;
};

/// Reads the properties of a line, defaults where they are missing.
class Properties {
 public:
  Properties(const NamedLine& line, const LineReader& reader, const RouteDefaults& defaults)
      : line_(line), reader_(reader), defaults_(defaults) {}

  [[nodiscard]] bool names_fan() const {
    return line_.properties.contains("port_deg") || line_.properties.contains("stbd_deg");
  }

  /// Other programs may say other things of a line.
  [[nodiscard]] bool infeasible() const {
    const auto status = line_.properties.find("status");
    return status != line_.properties.end() && *status == "infeasible";
  }

  [[nodiscard]] Waypoint waypoint(std::size_t point) const {
    return {.position = line_.points[point],
            .kind = kind(),
            .log = log(),
            .line = whole("line"),
            .fan = names_fan() ? fan(point) : defaults_.fan,
            .speed_mps = speed(point),
            .region = whole("region"),
            .feasible = !infeasible()};
  }

 private:
  [[nodiscard]] const Json* find(const std::string& name) const {
    const auto at = line_.properties.find(name);
    return at == line_.properties.end() || at->is_null() ? nullptr : &*at;
  }

  /// The figure at a point: from the list of the points if there is one.
  [[nodiscard]] std::optional<double> figure(const std::string& name, std::size_t point) const {
    const Json* value = find(name);
    const Json* list = find(name + "_at_points");
    if (list != nullptr && list->is_array() && point < list->size()) value = &(*list)[point];
    if (value == nullptr || value->is_null()) return std::nullopt;
    if (!value->is_number()) reader_.fail(line_.label, name + " is not a number");
    return value->get<double>();
  }

  [[nodiscard]] std::optional<int> whole(const char* name) const {
    const Json* value = find(name);
    if (value == nullptr || !value->is_number_integer()) return std::nullopt;
    return value->get<int>();
  }

  [[nodiscard]] LegKind kind() const {
    const Json* value = find("kind");
    if (value == nullptr) return LegKind::line;
    const auto known = value->is_string() ? leg_kind(value->get<std::string>()) : std::nullopt;
    if (!known || *known == LegKind::end) {
      reader_.fail(line_.label,
                   fmt::format("kind {} is none of line, turn, transit, cross, infill, patch, "
                               "run_in, run_out",
                               value->is_string() ? value->dump() : value->type_name()));
    }
    return *known;
  }

  [[nodiscard]] bool log() const {
    const Json* value = find("log");
    if (value == nullptr) return true;
    if (value->is_boolean()) return value->get<bool>();
    const double flag = value->is_number() ? value->get<double>() : -1.0;
    if (flag != 0.0 && flag != 1.0) reader_.fail(line_.label, "log must be 0 or 1");
    return flag == 1.0;
  }

  [[nodiscard]] std::optional<FanAngles> fan(std::size_t point) const {
    const auto port = figure("port_deg", point), stbd = figure("stbd_deg", point);
    if (!port && !stbd) return std::nullopt;
    for (const auto& side : {port, stbd}) {
      if (!side || *side <= 0.0 || *side >= 90.0) {
        reader_.fail(line_.label,
                     "port_deg and stbd_deg must both lie between 0 and 90 degrees, both excluded");
      }
    }
    return FanAngles{.port = Angle::degrees(*port), .starboard = Angle::degrees(*stbd)};
  }

  [[nodiscard]] double speed(std::size_t point) const {
    const double value = figure("speed_mps", point).value_or(defaults_.speed_mps);
    if (!(value > 0.0)) reader_.fail(line_.label, "speed_mps must be greater than 0");
    return value;
  }

  const NamedLine& line_;
  const LineReader& reader_;
  const RouteDefaults& defaults_;
};

Json parse(std::string_view text, const std::string& file) {
  if (const std::size_t levels = nesting_of_json(text); levels > kMostNesting) {
    throw InvalidInput(
        fmt::format("'{}' is JSON nested {} levels deep, and no route needs more than {}; write it "
                    "as GeoJSON or CSV",
                    file, levels, kMostNesting));
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InvalidInput(
        fmt::format("'{}' is not complete JSON: byte {} cannot be read; is the file "
                    "truncated?",
                    file, error.byte));
  }
}

/// The waypoints of the lines, joined to one route. Returns the number of gaps between them.
std::size_t join(const std::vector<NamedLine>& lines, const LineReader& reader,
                 const RouteDefaults& defaults, Route& route) {
  std::vector<std::vector<Waypoint>> waypoints;
  for (const NamedLine& line : lines) {
    const Properties properties(line, reader, defaults);
    waypoints.emplace_back();
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      waypoints.back().push_back(properties.waypoint(i));
    }
  }
  return join_lines(waypoints, route);
}

void check_fans(const std::vector<NamedLine>& lines, const LineReader& reader,
                const RouteDefaults& defaults, ImportedRoute& imported) {
  for (const NamedLine& line : lines) {
    if (Properties(line, reader, defaults).names_fan()) continue;
    if (!defaults.fan) {
      reader.fail(line.label,
                  "has no port_deg and stbd_deg: add them or give the opening angle of the fan");
    }
    imported.fan_note = fmt::format(
        "lines without a fan: {} degrees to port and {} to starboard were taken",
        decimal(defaults.fan->port.deg(), 2), decimal(defaults.fan->starboard.deg(), 2));
    return;
  }
}

}  // namespace

ImportedRoute parse_route_geojson(std::string_view text, const std::string& name,
                                  const Frame& frame, const RouteDefaults& defaults) {
  const Json document = parse(text, name);
  LineReader reader(name);
  reader.read(document, Json::object(), "the document");
  const bool of_places = reader.join_places();
  if (reader.lines().empty()) {
    throw InvalidInput(
        fmt::format("'{}' is not a route: it holds neither a LineString nor two points", name));
  }
  const PointPlacer placer(document, name, frame);
  for (NamedLine& line : reader.lines()) placer.place(line);
  ImportedRoute imported;
  check_fans(reader.lines(), reader, defaults, imported);
  if (const std::size_t gaps = join(reader.lines(), reader, defaults, imported.route); gaps > 0) {
    imported.notes.push_back(gaps_note(gaps));
  }
  if (of_places) {
    imported.notes.emplace_back("the file holds no line: its points were joined in their order");
  }
  if (reader.others() > 0) {
    imported.notes.push_back(
        fmt::format("{} geometries that are no lines were left out", reader.others()));
  }
  if (const auto why = fault(imported.route)) {
    throw InvalidInput(fmt::format("'{}' is not a valid route: {}", name, *why));
  }
  return imported;
}

}  // namespace swathplan

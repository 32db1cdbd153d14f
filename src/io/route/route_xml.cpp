#include "io/route/route_xml.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/text.h"
#include "io/route/xml_tree_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using internal::attribute;
using internal::children;
using internal::local_name;
using internal::text_of_child;
using Node = CPLXMLNode;

constexpr double kMpsPerKnot = 1852.0 / 3600.0;

Vec2 place_of(const Node& node, const std::string& file, const std::string& label) {
  const auto lat = to_finite_number(attribute(node, "lat"));
  const auto lon = to_finite_number(attribute(node, "lon"));
  if (lat && lon) return {*lon, *lat};
  throw InvalidInput(fmt::format("'{}', {}: lat '{}', lon '{}' are not two numbers", file, label,
                                 quotable(attribute(node, "lat")),
                                 quotable(attribute(node, "lon"))));
}

void note_left_out(ForeignRoute& route, std::size_t count, const char* what) {
  if (count > 0) route.notes.push_back(fmt::format("{} {} were left out", count, what));
}

/// Points of GPX that have a place and perhaps a name and a kind.
std::vector<ForeignPoint> gpx_points(const std::vector<const Node*>& nodes, ForeignRoute& route,
                                     const std::string& file) {
  std::vector<ForeignPoint> points;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ForeignPoint point{.place = place_of(*nodes[i], file, fmt::format("point {}", i + 1)),
                       .line = std::nullopt,
                       .speed_mps = std::nullopt};
    if (const auto kind = leg_kind(text_of_child(*nodes[i], "type"))) {
      point.kind = *kind == LegKind::end ? LegKind::line : *kind;
      route.names_kinds = true;
    }
    points.push_back(point);
    // Plotters cut names short; the whole one may stand in the description.
    const std::string_view described = text_of_child(*nodes[i], "desc");
    names.emplace_back(described.empty() ? text_of_child(*nodes[i], "name") : described);
  }
  number_lines(names, points);
  return points;
}

ForeignRoute read_gpx(const Node& root, const std::string& file) {
  ForeignRoute route;
  const auto tracks = children(root, "trk");
  const auto places = children(root, "wpt");
  for (const Node* rte : children(root, "rte")) {
    route.parts.push_back(gpx_points(children(*rte, "rtept"), route, file));
  }
  std::erase_if(route.parts, [](const auto& part) { return part.empty(); });
  if (!route.parts.empty()) {
    note_left_out(route, tracks.size(), "tracks beside the routes");
  } else {
    for (const Node* track : tracks) {
      for (const Node* segment : children(*track, "trkseg")) {
        route.parts.push_back(gpx_points(children(*segment, "trkpt"), route, file));
      }
    }
    std::erase_if(route.parts, [](const auto& part) { return part.empty(); });
  }
  if (route.parts.empty()) {
    route.parts.push_back(gpx_points(places, route, file));
    route.notes.emplace_back("the file holds no route: its waypoints were joined in their order");
  } else {
    note_left_out(route, places.size(), "waypoints beside the routes and tracks");
  }
  return route;
}

/// 'lon,lat[,height]' of a tuple of KML, separated by commas, or by blanks in a track.
Vec2 kml_place(std::string_view tuple, char separator, const std::string& file) {
  const auto fields = split(tuple, separator);
  const auto lon = fields.size() < 2 ? std::nullopt : to_finite_number(fields[0]);
  const auto lat = fields.size() < 2 ? std::nullopt : to_finite_number(fields[1]);
  if (lon && lat) return {*lon, *lat};
  throw InvalidInput(fmt::format("'{}': '{}' is no 'longitude,latitude'", file, quotable(tuple)));
}

/// Collects the lines of a KML document.
class KmlReader {
 public:
  explicit KmlReader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] ForeignRoute read(const Node& root) {
    walk(root, {}, 0);
    const bool ordered = std::all_of(lines_.begin(), lines_.end(),
                                     [](const Line& line) { return line.leg.has_value(); });
    if (ordered) {
      std::stable_sort(lines_.begin(), lines_.end(),
                       [](const Line& a, const Line& b) { return *a.leg < *b.leg; });
    }
    for (Line& line : lines_) route_.parts.push_back(std::move(line.points));
    if (lines_.empty() && !places_.empty()) {
      route_.parts.push_back(std::move(places_));
      route_.notes.emplace_back("the file holds no line: its places were joined in their order");
    } else {
      note_left_out(route_, places_.size(), "places beside the lines");
    }
    note_left_out(route_, areas_, "polygons");
    note_left_out(route_, links_, "links to other files");
    return std::move(route_);
  }

 private:
  struct Line {
    std::optional<int> leg;  ///< its place in a route of this program
    std::vector<ForeignPoint> points;
  };

  /// What a placemark or a folder says of the lines in it.
  struct Says {
    std::optional<LegKind> kind;
    std::optional<int> line, leg;
  };

  void walk(const Node& node, Says says, int depth) {
    constexpr int kMostDepth = 100;
    if (depth > kMostDepth) {
      throw InvalidInput(fmt::format("'{}': its folders are nested too deeply", file_));
    }
    const std::string_view name = local_name(node);
    if (name == "Folder") says = said_by_folder(node);
    if (name == "Placemark") says = said_by_placemark(node, says);
    if (name == "LineString" || name == "LinearRing") {
      add_line(coordinates(node), says);
    } else if (name == "Track") {
      add_line(track(node), says);
    } else if (name == "Point") {
      for (const ForeignPoint& p : coordinates(node)) places_.push_back(p);
    } else if (name == "Polygon") {
      ++areas_;
    } else if (name == "NetworkLink") {
      ++links_;
    } else {
      for (const Node* child : children(node)) walk(*child, says, depth + 1);
    }
  }

  static Says said_by_folder(const Node& folder) {
    return {.kind = survey_kind(text_of_child(folder, "name")),
            .line = std::nullopt,
            .leg = std::nullopt};
  }

  static Says said_by_placemark(const Node& placemark, const Says& folder) {
    Says says = folder;
    for (const Node* data : children(placemark, "ExtendedData")) {
      for (const Node* value : children(*data, "Data")) {
        if (attribute(*value, "name") == "leg")
          says.leg = whole_number(text_of_child(*value, "value"));
      }
    }
    const auto words = split(text_of_child(placemark, "name"), ' ');
    if (says.kind && words.size() == 2 && survey_kind(words[0]) == says.kind) {
      says.line = whole_number(words[1]);
    }
    return says;
  }

  static std::optional<LegKind> survey_kind(std::string_view name) {
    const auto kind = leg_kind(name);
    return kind == LegKind::end ? std::nullopt : kind;
  }

  [[nodiscard]] std::vector<ForeignPoint> coordinates(const Node& node) const {
    std::vector<ForeignPoint> points;
    for (const std::string_view tuple : split(text_of_child(node, "coordinates"), ' ')) {
      points.push_back(
          {.place = kml_place(tuple, ',', file_), .line = std::nullopt, .speed_mps = std::nullopt});
    }
    return points;
  }

  [[nodiscard]] std::vector<ForeignPoint> track(const Node& node) const {
    std::vector<ForeignPoint> points;
    for (const Node* place : children(node, "coord")) {
      points.push_back({.place = kml_place(internal::text_in(*place), ' ', file_),
                        .line = std::nullopt,
                        .speed_mps = std::nullopt});
    }
    return points;
  }

  void add_line(std::vector<ForeignPoint> points, const Says& says) {
    if (points.empty()) return;
    if (says.kind) route_.names_kinds = true;
    for (ForeignPoint& p : points) {
      p.kind = says.kind.value_or(LegKind::line);
      p.line = says.line;
    }
    lines_.push_back({says.leg, std::move(points)});
  }

  std::string file_;
  ForeignRoute route_;
  std::vector<Line> lines_;
  std::vector<ForeignPoint> places_;
  std::size_t areas_ = 0, links_ = 0;
};

ForeignRoute read_rtz(const Node& root, const std::string& file) {
  ForeignRoute route;
  std::vector<ForeignPoint>& points = route.parts.emplace_back();
  std::vector<std::string> names;
  std::size_t rounded = 0;
  std::size_t great_circles = 0;
  for (const Node* list : children(root, "waypoints")) {
    for (const Node* waypoint : children(*list, "waypoint")) {
      const std::string label = fmt::format("waypoint {}", points.size() + 1);
      const auto places = children(*waypoint, "position");
      if (places.empty()) {
        throw InvalidInput(fmt::format("'{}', {}: has no position", file, label));
      }
      // The leg of a waypoint is the one that leads to it.
      for (const Node* leg : children(*waypoint, "leg")) {
        if (points.empty()) break;
        const auto knots = to_finite_number(attribute(*leg, "speedMax"));
        if (knots && *knots > 0.0) points.back().speed_mps = *knots * kMpsPerKnot;
        if (const auto kind = leg_kind(attribute(*leg, "legInfo")); kind && *kind != LegKind::end) {
          points.back().kind = *kind;
          route.names_kinds = true;
        }
        if (attribute(*leg, "geometryType") == "Orthodrome") ++great_circles;
      }
      if (to_finite_number(attribute(*waypoint, "radius")).value_or(0.0) > 0.0) ++rounded;
      points.push_back({.place = place_of(*places.front(), file, label),
                        .line = std::nullopt,
                        .speed_mps = std::nullopt});
      names.emplace_back(attribute(*waypoint, "name"));
    }
  }
  number_lines(names, points);
  note_left_out(route, rounded, "turn radii");
  if (great_circles > 0) {
    route.notes.push_back(fmt::format(
        "{} great-circle legs are taken as straight in the seafloor's coordinates", great_circles));
  }
  return route;
}

}  // namespace

ForeignRoute parse_route_xml(std::string_view text, const std::string& file) {
  const internal::XmlTree tree = internal::xml_tree(text, file);
  const std::string_view root = local_name(*tree.root);
  if (root == "gpx") return read_gpx(*tree.root, file);
  if (root == "kml") return KmlReader(file).read(*tree.root);
  if (root == "route") return read_rtz(*tree.root, file);
  throw InvalidInput(
      fmt::format("'{}' is XML of the kind '{}'; a route must be GPX, KML or RTZ, or one of the "
                  "other formats that are listed with the command",
                  file, quotable(root)));
}

}  // namespace swathplan

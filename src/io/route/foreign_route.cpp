#include "io/route/foreign_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/lonlat.h"
#include "io/files/text.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Two ends closer than this are one point: coordinates in files are rounded to a millimetre.
constexpr double kSamePointM = 2e-3;

std::size_t points_in(const ForeignRoute& route) {
  std::size_t count = 0;
  for (const auto& part : route.parts) count += part.size();
  return count;
}

void check_degrees(const ForeignRoute& route, const std::string& file, const Frame& frame) {
  if (!route.in_degrees) return;
  if (frame.crs_wkt.empty()) {
    throw InvalidInput(fmt::format(
        "'{}' is in longitude and latitude, but the seafloor has no CRS: give it with <CRS> EPSG:n",
        file));
  }
  std::size_t number = 0;
  for (const auto& part : route.parts) {
    for (const ForeignPoint& p : part) {
      ++number;
      if (std::abs(p.place.x()) <= 360.0 && std::abs(p.place.y()) <= 90.0) continue;
      throw InvalidInput(
          fmt::format("'{}', waypoint {}: latitude {:g}, longitude {:g} are not degrees", file,
                      number, p.place.y(), p.place.x()));
    }
  }
}

std::vector<Vec2> local(const std::vector<ForeignPoint>& part, bool in_degrees, const Frame& frame,
                        const std::optional<LonLat>& degrees) {
  std::vector<Vec2> points;
  points.reserve(part.size());
  for (const ForeignPoint& p : part) points.push_back(p.place);
  if (in_degrees) return degrees->to_local(points);
  for (Vec2& p : points) p = frame.to_local(p);
  return points;
}

void add_notes(const ForeignRoute& route, std::size_t gaps, bool some_speed, bool all_speeds,
               const RouteDefaults& defaults, ImportedRoute& imported) {
  imported.fan_note = fmt::format(
      "the route names no fan: {} degrees to port and {} to starboard were taken for all of it",
      decimal(defaults.fan->port.deg(), 2), decimal(defaults.fan->starboard.deg(), 2));
  imported.notes = route.notes;
  if (!route.names_kinds)
    imported.leg_notes.emplace_back("the route names no kinds: all are lines");
  if (!all_speeds) {
    imported.leg_notes.push_back(
        some_speed ? fmt::format("legs without a speed: {} m/s was taken", defaults.speed_mps)
                   : fmt::format("the route names no speed: {} m/s was taken", defaults.speed_mps));
  }
  if (gaps > 0) imported.notes.push_back(gaps_note(gaps));
}

}  // namespace

std::string gaps_note(std::size_t gaps) {
  return fmt::format("{} gap{} between lines {} joined by straight transits with the sonar off",
                     gaps, gaps == 1 ? "" : "s", gaps == 1 ? "was" : "were");
}

std::size_t join_lines(const std::vector<std::vector<Waypoint>>& lines, Route& route) {
  std::size_t gaps = 0;
  auto& waypoints = route.waypoints;
  for (const std::vector<Waypoint>& line : lines) {
    if (!waypoints.empty()) {
      if ((waypoints.back().position - line.front().position).norm() <= kSamePointM) {
        waypoints.pop_back();
      } else {
        ++gaps;
        waypoints.back() = {.position = waypoints.back().position,
                            .kind = LegKind::transit,
                            .log = false,
                            .line = std::nullopt,
                            .fan = std::nullopt,
                            .speed_mps = waypoints.back().speed_mps,
                            .region = std::nullopt};
      }
    }
    waypoints.insert(waypoints.end(), line.begin(), line.end());
  }
  waypoints.back().kind = LegKind::end;
  return gaps;
}

ImportedRoute placed(ForeignRoute route, const std::string& file, const Frame& frame,
                     const RouteDefaults& defaults) {
  std::erase_if(route.parts, [](const auto& part) { return part.empty(); });
  if (const std::size_t points = points_in(route); points < 2) {
    throw InvalidInput(fmt::format("'{}' holds {} waypoint{}: a route needs at least two", file,
                                   points == 0 ? "no" : "one", points == 0 ? "s" : ""));
  }
  check_degrees(route, file, frame);
  if (!defaults.fan) {
    throw InvalidInput(fmt::format("'{}' names no fan: give the opening angle of the fan", file));
  }
  std::optional<LonLat> degrees;
  if (route.in_degrees) degrees.emplace(frame);
  bool some_speed = false;
  bool all_speeds = true;
  std::vector<std::vector<Waypoint>> lines;
  for (const auto& part : route.parts) {
    const std::vector<Vec2> points = local(part, route.in_degrees, frame, degrees);
    std::vector<Waypoint>& line = lines.emplace_back();
    for (std::size_t i = 0; i < part.size(); ++i) {
      line.push_back({.position = points[i],
                      .kind = part[i].kind,
                      .log = is_survey(part[i].kind),
                      .line = part[i].line,
                      .fan = defaults.fan,
                      .speed_mps = part[i].speed_mps.value_or(defaults.speed_mps),
                      .region = std::nullopt});
      if (i + 1 == part.size()) continue;
      some_speed = some_speed || part[i].speed_mps.has_value();
      all_speeds = all_speeds && part[i].speed_mps.has_value();
    }
  }
  ImportedRoute imported;
  const std::size_t gaps = join_lines(lines, imported.route);
  add_notes(route, gaps, some_speed, all_speeds, defaults, imported);
  if (const auto why = fault(imported.route)) {
    throw InvalidInput(fmt::format("'{}' is not a valid route: {}", file, *why));
  }
  return imported;
}

std::optional<int> whole_number(std::string_view text) {
  const auto value = to_finite_number(text);
  if (!value || *value != std::floor(*value) || std::abs(*value) > 1e9) return std::nullopt;
  return static_cast<int>(*value);
}

void number_lines(const std::vector<std::string>& names, std::vector<ForeignPoint>& points) {
  std::optional<int> line;
  for (std::size_t i = 0; i < std::min(names.size(), points.size()); ++i) {
    for (const std::string_view name : split(names[i], ',')) {
      const auto words = split(name, ' ');
      if (words.size() != 3 || words[0] != "line") continue;
      if (words[2] == "end") line.reset();
      // A second stretch of line 3 is '3_2'.
      if (words[2] == "start") line = whole_number(words[1].substr(0, words[1].find('_')));
    }
    if (is_survey(points[i].kind)) points[i].line = line;
  }
}

}  // namespace swathplan

#include "io/route/read_route.h"

#include "io/files/text.h"
#include "io/route/foreign_route.h"
#include "io/route/planned_lines_read.h"
#include "io/route/route_csv.h"
#include "io/route/route_geojson.h"
#include "io/route/route_gpkg_read.h"
#include "io/route/route_mission.h"
#include "io/route/route_planar.h"
#include "io/route/route_ros_read.h"
#include "io/route/route_xml.h"

namespace swathplan {
namespace {

/// The first lines of a text, trimmed, without the empty ones.
std::vector<std::string_view> first_lines(std::string_view text) {
  constexpr std::size_t kMost = 2000;
  std::vector<std::string_view> lines;
  for (const std::string_view line : split(text.substr(0, kMost), '\n')) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

bool is_lnw(const std::vector<std::string_view>& lines) {
  const std::string first = lower(lines[0]);
  return first.starts_with("lns ") || first.starts_with("lnw ") || first.starts_with("lin ");
}

/// Group codes and values take turns; a comment (999) may stand first.
bool is_dxf(const std::vector<std::string_view>& lines) {
  if (lines.size() < 2) return false;
  return lines[0] == "999" || (lines[0] == "0" && lines[1] == "SECTION");
}

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return trim(text);
}

}  // namespace

RouteFormat route_format(std::string_view text) {
  const std::string_view content = without_mark(text);
  if (content.starts_with('{')) {
    const bool plan = content.find("\"mission\"") != std::string_view::npos &&
                      content.find("\"fileType\"") != std::string_view::npos;
    return plan ? RouteFormat::plan : RouteFormat::geojson;
  }
  if (content.starts_with("QGC WPL")) return RouteFormat::waypoints;
  if (content.starts_with('<')) return RouteFormat::xml;
  if (is_ros_path(content)) return RouteFormat::yaml;
  if (is_rln(content)) return RouteFormat::rln;
  if (is_asciiplan(content)) return RouteFormat::asciiplan;
  const auto lines = first_lines(content);
  if (!lines.empty() && is_lnw(lines)) return RouteFormat::lnw;
  return is_dxf(lines) ? RouteFormat::dxf : RouteFormat::csv;
}

bool is_always_lonlat(RouteFormat format) {
  return format == RouteFormat::plan || format == RouteFormat::waypoints ||
         format == RouteFormat::xml || format == RouteFormat::asciiplan;
}

ImportedRoute parse_route(std::string_view text, const std::string& file, const Frame& frame,
                          const RouteDefaults& defaults) {
  const std::string_view content = without_mark(text);
  switch (route_format(text)) {
    case RouteFormat::geojson:
      return parse_route_geojson(content, file, frame, defaults);
    case RouteFormat::plan:
      return placed(parse_mission_plan(content, file), file, frame, defaults);
    case RouteFormat::waypoints:
      return placed(parse_mission_waypoints(content, file), file, frame, defaults);
    case RouteFormat::xml:
      return placed(parse_route_xml(content, file), file, frame, defaults);
    case RouteFormat::lnw:
      return placed(parse_route_lnw(content, file), file, frame, defaults);
    case RouteFormat::dxf:
      return placed(parse_route_dxf(content, file), file, frame, defaults);
    case RouteFormat::rln:
      return placed(parse_route_rln(content, file), file, frame, defaults);
    case RouteFormat::asciiplan:
      return placed(parse_route_asciiplan(content, file), file, frame, defaults);
    case RouteFormat::yaml:
      return placed(parse_route_ros(content, file, frame.metres_per_unit), file, frame, defaults);
    case RouteFormat::csv:
      break;
  }
  return parse_route_csv(text, file, frame, defaults);
}

ImportedRoute read_route(const std::filesystem::path& path, const Frame& frame,
                         const RouteDefaults& defaults) {
  if (is_route_package(path)) return read_route_gpkg(path, frame, defaults);
  return parse_route(read_text(path), path.string(), frame, defaults);
}

}  // namespace swathplan

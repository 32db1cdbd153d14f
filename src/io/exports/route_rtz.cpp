#include "io/exports/route_rtz.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/exports/survey_runs.h"
#include "io/files/text.h"
#include "io/files/xml.h"
#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

constexpr double kMetresPerMile = 1852.0;
constexpr double kLargestRadius = 9.999999;  // miles; the schema's radii are below 10
constexpr int kRadiusDigits = 6;             // decimals of a mile: 2 mm

/// The radius of a turn in nautical miles; see route_rtz. 0 where the path turns back on itself or
/// a leg has no length.
double turn_radius(const Vec2& before, const Vec2& at, const Vec2& after, double tolerance_m) {
  const Vec2 in = at - before;
  const Vec2 out = after - at;
  const double shorter = std::min(in.norm(), out.norm());
  if (!(shorter > 0.0)) return 0.0;
  const double half = 0.5 * std::abs(turn_angle(in, out));
  // The circle touches both legs r tan(half) from the corner and passes it at r (1/cos(half) - 1).
  const double cosine = std::cos(half);
  const double fits = 0.5 * shorter * cosine / std::sin(half);
  const double cuts = tolerance_m * cosine / (1.0 - cosine);
  const double radius = std::min(fits, cuts) / kMetresPerMile;
  return std::isfinite(radius) ? std::min(radius, kLargestRadius) : kLargestRadius;
}

std::string waypoint_head(const GeographicRoute& route, std::size_t i, const std::string& name,
                          double tolerance_m) {
  const auto& w = route.route.waypoints;
  const bool corner = i > 0 && i + 1 < w.size();
  const std::string radius =
      corner ? fmt::format(" radius=\"{}\"", decimal(turn_radius(w[i - 1].position, w[i].position,
                                                                 w[i + 1].position, tolerance_m),
                                                     kRadiusDigits))
             : "";
  return fmt::format(
      "<waypoint id=\"{}\" name=\"{}\"{}>\n<position lat=\"{:.8f}\" lon=\"{:.8f}\"/>\n", i + 1,
      xml_escaped(name), radius, route.lonlat[i].y(),
      // The schema's longitudes end before 180.
      route.lonlat[i].x() >= 180.0 ? -180.0 : route.lonlat[i].x());
}

/// The leg that leads from a waypoint to the next one; it is written with the next one.
std::string leg(const Waypoint& from) {
  const double knots = from.speed_mps * 3600.0 / kMetresPerMile;
  return fmt::format("<leg geometryType=\"Loxodrome\" speedMax=\"{}\" legInfo=\"{}\"/>\n",
                     decimal(knots, 3), name(from.kind));
}

}  // namespace

std::string route_rtz(const GeographicRoute& route, const std::string& name, double tolerance_m) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<route xmlns=\"http://www.cirm.org/RTZ/1/0\" version=\"1.0\">\n"
      "<routeInfo routeName=\"{}\" routeAuthor=\"swathplan\"/>\n<waypoints>\n",
      xml_escaped(name));
  const std::vector<std::string> names = waypoint_names(route.route);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += waypoint_head(route, i, names[i], tolerance_m);
    if (i > 0) text += leg(route.route.waypoints[i - 1]);
    text += "</waypoint>\n";
  }
  return text + "</waypoints>\n</route>\n";
}

}  // namespace swathplan

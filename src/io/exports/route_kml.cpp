#include "io/exports/route_kml.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "io/files/xml.h"

namespace swathplan {
namespace {

struct Look {
  LegKind kind;
  const char* colour;  ///< alpha, blue, green, red
};

constexpr std::array<Look, 7> kLooks{{{LegKind::line, "ffb45a00"},
                                      {LegKind::cross, "ff9b2d96"},
                                      {LegKind::infill, "ff328c00"},
                                      {LegKind::turn, "ff00a5ff"},
                                      {LegKind::transit, "ff808080"},
                                      {LegKind::run_in, "ff46c8f0"},
                                      {LegKind::run_out, "ff46c8f0"}}};

std::string placemark(const GeographicRoute& route, const Leg& leg, std::size_t number) {
  const Waypoint& w = route.route.waypoints[leg.first];
  std::string text = fmt::format(
      "<Placemark><name>{}</name><styleUrl>#{}</styleUrl><LineString><tessellate>1</tessellate>"
      "<coordinates>",
      w.line ? fmt::format("{} {}", name(w.kind), *w.line) : fmt::format("leg {}", number),
      name(w.kind));
  for (std::size_t i = leg.first; i <= leg.last; ++i) {
    fmt::format_to(std::back_inserter(text), "{}{:.8f},{:.8f}", i == leg.first ? "" : " ",
                   route.lonlat[i].x(), route.lonlat[i].y());
  }
  return text + "</coordinates></LineString></Placemark>\n";
}

}  // namespace

std::string route_kml(const GeographicRoute& route, const std::string& name) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n"
      "<Document><name>{}</name>\n",
      xml_escaped(name));
  for (const Look& look : kLooks) {
    text += fmt::format(
        "<Style id=\"{}\"><LineStyle><color>{}</color><width>2</width></LineStyle></Style>\n",
        swathplan::name(look.kind), look.colour);
  }
  const std::vector<Leg> all = legs(route.route);
  for (const Look& look : kLooks) {
    std::string marks;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (route.route.waypoints[all[i].first].kind == look.kind) {
        marks += placemark(route, all[i], i + 1);
      }
    }
    if (marks.empty()) continue;
    text +=
        fmt::format("<Folder><name>{}</name>\n{}</Folder>\n", swathplan::name(look.kind), marks);
  }
  return text + "</Document>\n</kml>\n";
}

}  // namespace swathplan

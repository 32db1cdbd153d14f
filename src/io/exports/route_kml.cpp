#include "io/exports/route_kml.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "io/files/geojson.h"
#include "io/files/xml.h"

namespace swathplan {
namespace {

struct Look {
  LegKind kind;
  const char* colour;  ///< alpha, blue, green, red
};

constexpr std::array<Look, 8> kLooks{{{LegKind::line, "ffb45a00"},
                                      {LegKind::cross, "ff9b2d96"},
                                      {LegKind::infill, "ff328c00"},
                                      {LegKind::patch, "ff50508c"},
                                      {LegKind::turn, "ff00a5ff"},
                                      {LegKind::transit, "ff808080"},
                                      {LegKind::run_in, "ff46c8f0"},
                                      {LegKind::run_out, "ff46c8f0"}}};

std::string placemark(const GeographicRoute& route, const Leg& leg, std::size_t number) {
  const Waypoint& w = route.route.waypoints[leg.first];
  std::string text = fmt::format(
      "<Placemark><name>{}</name><styleUrl>#{}</styleUrl><ExtendedData><Data name=\"leg\"><value>{}"
      "</value></Data></ExtendedData>",
      w.line ? fmt::format("{} {}", name(w.kind), *w.line) : fmt::format("leg {}", number),
      name(w.kind), number);
  const auto begin = route.lonlat.begin();
  const auto parts = cut_at_180({begin + static_cast<std::ptrdiff_t>(leg.first),
                                 begin + static_cast<std::ptrdiff_t>(leg.last) + 1});
  if (parts.size() > 1) text += "<MultiGeometry>";
  for (const std::vector<CutPlace>& part : parts) {
    text += "<LineString><tessellate>1</tessellate><coordinates>";
    for (std::size_t i = 0; i < part.size(); ++i) {
      fmt::format_to(std::back_inserter(text), "{}{:.8f},{:.8f}", i == 0 ? "" : " ",
                     part[i].lonlat.x(), part[i].lonlat.y());
    }
    text += "</coordinates></LineString>";
  }
  if (parts.size() > 1) text += "</MultiGeometry>";
  return text + "</Placemark>\n";
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

#include "io/exports/route_gpx.h"

#include <fmt/format.h>

#include <iterator>

#include "io/exports/survey_runs.h"
#include "io/files/xml.h"

namespace swathplan {

std::string route_gpx(const GeographicRoute& route, const std::string& name) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<gpx version=\"1.1\" creator=\"swathplan\" xmlns=\"http://www.topografix.com/GPX/1/1\" "
      "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
      "xsi:schemaLocation=\"http://www.topografix.com/GPX/1/1 "
      "http://www.topografix.com/GPX/1/1/gpx.xsd\">\n<rte>\n<name>{}</name>\n",
      xml_escaped(name));
  const std::vector<std::string> names = waypoint_names(route.route);
  const std::vector<std::string> short_names = short_waypoint_names(route.route);
  for (std::size_t i = 0; i < names.size(); ++i) {
    fmt::format_to(std::back_inserter(text),
                   "<rtept lat=\"{:.8f}\" lon=\"{:.8f}\"><name>{}</name><desc>{}</desc>"
                   "<type>{}</type></rtept>\n",
                   route.lonlat[i].y(), route.lonlat[i].x(), xml_escaped(short_names[i]),
                   xml_escaped(names[i]), swathplan::name(route.route.waypoints[i].kind));
  }
  return text + "</rte>\n</gpx>\n";
}

}  // namespace swathplan

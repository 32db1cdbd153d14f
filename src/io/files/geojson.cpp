#include "io/files/geojson.h"

#include <fmt/format.h>

#include "io/files/lonlat.h"
#include "io/files/text.h"

namespace swathplan {

std::string geojson_head(const Frame& frame) {
  std::string head = R"({"type":"FeatureCollection",)";
  if (frame.crs_wkt.empty()) {
    head += fmt::format(
        R"("local_frame":{{"unit_m":{},"note":"coordinates are x (east) and y (north) of the )"
        R"(input file, which has no CRS; they are not longitude and latitude"}},)",
        frame.metres_per_unit);
  }
  return head + R"("features":[)";
}

std::vector<std::string> geojson_positions(const std::vector<Vec2>& local, const Frame& frame) {
  const LonLat conversion(frame);
  const std::vector<Vec2> lonlat =
      conversion.known() ? conversion.from_local(local) : std::vector<Vec2>();
  std::vector<std::string> out;
  out.reserve(local.size());
  for (std::size_t i = 0; i < local.size(); ++i) {
    const Vec2 p = conversion.known() ? lonlat[i] : frame.to_file(local[i]);
    const int decimals = conversion.known() ? 11 : 6;  // a micrometre: finer than curves need
    out.push_back(fmt::format("[{},{}]", decimal(p.x(), decimals), decimal(p.y(), decimals)));
  }
  return out;
}

std::string geojson_name(const std::string& stem, const Frame& frame) {
  return stem + (frame.crs_wkt.empty() ? ".local.geojson" : ".geojson");
}

}  // namespace swathplan

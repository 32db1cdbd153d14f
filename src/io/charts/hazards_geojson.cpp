#include "io/charts/hazards_geojson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

std::string ring_text(Ring ring, const Frame& frame) {
  if (!ring.empty()) ring.push_back(ring.front());
  return fmt::format("[{}]", fmt::join(geojson_positions(ring, frame), ","));
}

std::string polygons_text(const Area& area, const Frame& frame) {
  std::vector<std::string> polygons;
  for (const Polygon& polygon : area) {
    std::vector<std::string> rings{ring_text(polygon.outer, frame)};
    for (const Ring& hole : polygon.holes) rings.push_back(ring_text(hole, frame));
    polygons.push_back(fmt::format("[{}]", fmt::join(rings, ",")));
  }
  return fmt::format("{}", fmt::join(polygons, ","));
}

/// Names in files are data: quotation marks and control characters are written as JSON wants them.
std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  }
  return out + "\"";
}

std::string feature_text(const Hazard& hazard, const Frame& frame) {
  return fmt::format(
      R"({{"type":"Feature","properties":{{"layer":{},"name":{},"buffer_m":{},"accuracy_m":{},)"
      R"("accuracy_from":{},"to_be_seen":{}}},"geometry":{{"type":"MultiPolygon","coordinates":[{}]}}}})",
      json_string(hazard.layer), json_string(hazard.name), decimal(hazard.buffer_m, 2),
      decimal(hazard.accuracy_m, 2), json_string(hazard.accuracy_from), hazard.to_be_seen,
      polygons_text(hazard.area, frame));
}

}  // namespace

std::string hazards_geojson(const Hazards& hazards, const Frame& frame) {
  std::string text = geojson_head(frame);
  for (std::size_t i = 0; i < hazards.list.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + feature_text(hazards.list[i], frame);
  }
  return text + geojson_tail();
}

void write_hazards_geojson(const std::filesystem::path& folder, const Hazards& hazards,
                           const Frame& frame) {
  write_text_atomically(folder / "hazards.geojson", hazards_geojson(hazards, frame));
}

}  // namespace swathplan

#include "io/results/holidays_geojson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
#include "io/files/lonlat.h"
#include "io/files/text.h"
#include "io/files/units.h"

namespace swathplan {
namespace {

Ring corners(const Box2& box) {
  return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

Polygon outline_or_box(const Holiday& holiday) {
  return holiday.outline.outer.empty() ? Polygon{corners(holiday.box), {}} : holiday.outline;
}

std::string ring_text(const std::vector<std::string>& positions) {
  return fmt::format("[{},{}]", fmt::join(positions, ","), positions.front());
}

/// Writes the places of holidays as GeoJSON geometries.
class Places {
 public:
  explicit Places(const Frame& frame) : frame_(frame), conversion_(frame) {}

  /// What is drawn of the holiday: 'cells' or 'box', and the geometry.
  [[nodiscard]] std::pair<std::string, std::string> of(const Holiday& holiday) const {
    const Polygon polygon = outline_or_box(holiday);
    const char* const what = holiday.outline.outer.empty() ? "box" : "cells";
    if (!conversion_.known()) {
      std::vector<std::string> rings{ring_text(geojson_positions(polygon.outer, frame_))};
      for (const Ring& hole : polygon.holes) {
        rings.push_back(ring_text(geojson_positions(hole, frame_)));
      }
      return {what, polygon_text(rings)};
    }
    if (ring_cut_at_180(conversion_.from_local(polygon.outer)).size() > 1) {
      return {"box", cut_box(holiday)};
    }
    std::vector<std::string> rings{ring_of(polygon.outer)};
    for (const Ring& hole : polygon.holes) rings.push_back(ring_of(hole));
    return {what, polygon_text(rings)};
  }

 private:
  static std::string polygon_text(const std::vector<std::string>& rings) {
    return fmt::format(R"({{"type":"Polygon","coordinates":[{}]}})", fmt::join(rings, ","));
  }

  [[nodiscard]] std::string ring_of(const Ring& ring) const {
    std::vector<std::string> texts;
    for (const Vec2& p : conversion_.from_local(ring)) texts.push_back(geojson_lonlat(p));
    return ring_text(texts);
  }

  /// The box of a gap that crosses 180 degrees, in two parts.
  [[nodiscard]] std::string cut_box(const Holiday& holiday) const {
    std::vector<std::string> polygons;
    for (const auto& ring : ring_cut_at_180(conversion_.from_local(corners(holiday.box)))) {
      std::vector<std::string> texts;
      for (const Vec2& p : ring) texts.push_back(geojson_lonlat(p));
      polygons.push_back("[" + ring_text(texts) + "]");
    }
    return fmt::format(R"({{"type":"MultiPolygon","coordinates":[{}]}})", fmt::join(polygons, ","));
  }

  const Frame& frame_;
  LonLat conversion_;
};

std::string properties(const Holiday& h, std::size_t rank, const std::string& drawn,
                       const Frame& frame) {
  const Vec2 file = frame.to_file(h.position);
  const std::string_view unit = unit_mark(frame.metres_per_unit);
  return fmt::format(
      R"({{"rank":{},"area_m2":{},"cells":{},"cause":"{}","x_{}":{},"y_{}":{},"outline":"{}"}})",
      rank, decimal(h.area_m2, 6), h.cells, name(h.cause), unit, decimal(file.x(), 3), unit,
      decimal(file.y(), 3), drawn);
}

}  // namespace

std::string holidays_geojson(const Holidays& holidays, const Frame& frame) {
  const Places places(frame);
  std::string text = geojson_head(frame);
  for (std::size_t i = 0; i < holidays.list.size(); ++i) {
    const auto [drawn, geometry] = places.of(holidays.list[i]);
    text += fmt::format(R"({}{{"type":"Feature","properties":{},"geometry":{}}})",
                        i == 0 ? "\n" : ",\n", properties(holidays.list[i], i + 1, drawn, frame),
                        geometry);
  }
  text += fmt::format("\n],\"holidays\":{},\"listed\":{},\"holidays_total_m2\":{}}}\n",
                      holidays.count, holidays.list.size(), decimal(holidays.total_m2, 6));
  return text;
}

std::filesystem::path write_holidays_geojson(const std::filesystem::path& folder,
                                             const Holidays& holidays, const Frame& frame) {
  std::filesystem::path path = folder / geojson_name("holidays", frame);
  write_text_atomically(path, holidays_geojson(holidays, frame));
  return path;
}

}  // namespace swathplan

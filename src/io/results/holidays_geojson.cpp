#include "io/results/holidays_geojson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
#include "io/files/lonlat.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

std::vector<Vec2> corners(const Holidays& holidays) {
  std::vector<Vec2> out;
  for (const Holiday& h : holidays.list) {
    out.push_back(h.box.min);
    out.emplace_back(h.box.max.x(), h.box.min.y());
    out.push_back(h.box.max);
    out.emplace_back(h.box.min.x(), h.box.max.y());
  }
  return out;
}

/// A rectangle, in two parts where it crosses 180 degrees.
std::string geometry(const std::vector<std::string>& at, const std::vector<Vec2>& lonlat,
                     std::size_t first) {
  std::vector<std::vector<std::string>> rings;
  if (lonlat.empty()) {
    rings.push_back({at[first], at[first + 1], at[first + 2], at[first + 3]});
  } else {
    for (const auto& ring : ring_cut_at_180(
             {lonlat[first], lonlat[first + 1], lonlat[first + 2], lonlat[first + 3]})) {
      std::vector<std::string>& texts = rings.emplace_back();
      for (const Vec2& p : ring) texts.push_back(geojson_lonlat(p));
    }
  }
  std::vector<std::string> polygons;
  for (const auto& ring : rings) {
    polygons.push_back(fmt::format("[[{},{}]]", fmt::join(ring, ","), ring.front()));
  }
  if (polygons.size() == 1) {
    return fmt::format(R"({{"type":"Polygon","coordinates":{}}})", polygons.front());
  }
  return fmt::format(R"({{"type":"MultiPolygon","coordinates":[{}]}})", fmt::join(polygons, ","));
}

std::string properties(const Holiday& h, std::size_t rank, const Frame& frame) {
  const Vec2 file = frame.to_file(h.position);
  return fmt::format(R"({{"rank":{},"area_m2":{},"cells":{},"cause":"{}","x_m":{},"y_m":{}}})",
                     rank, decimal(h.area_m2, 6), h.cells, name(h.cause), decimal(file.x(), 3),
                     decimal(file.y(), 3));
}

}  // namespace

std::string holidays_geojson(const Holidays& holidays, const Frame& frame) {
  const LonLat conversion(frame);
  std::vector<Vec2> lonlat;
  std::vector<std::string> at;
  if (conversion.known()) {
    lonlat = conversion.from_local(corners(holidays));
  } else {
    at = geojson_positions(corners(holidays), frame);
  }
  std::string text = geojson_head(frame);
  for (std::size_t i = 0; i < holidays.list.size(); ++i) {
    text += fmt::format(R"({}{{"type":"Feature","properties":{},"geometry":{}}})",
                        i == 0 ? "\n" : ",\n", properties(holidays.list[i], i + 1, frame),
                        geometry(at, lonlat, 4 * i));
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

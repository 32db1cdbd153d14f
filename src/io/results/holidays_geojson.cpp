#include "io/results/holidays_geojson.h"

#include <fmt/format.h>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
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

std::string properties(const Holiday& h, std::size_t rank, const Frame& frame) {
  const Vec2 file = frame.to_file(h.position);
  return fmt::format(R"({{"rank":{},"area_m2":{},"cells":{},"cause":"{}","x_m":{},"y_m":{}}})",
                     rank, decimal(h.area_m2, 6), h.cells, name(h.cause), decimal(file.x(), 3),
                     decimal(file.y(), 3));
}

}  // namespace

std::string holidays_geojson(const Holidays& holidays, const Frame& frame) {
  const std::vector<std::string> at = geojson_positions(corners(holidays), frame);
  std::string text = geojson_head(frame);
  for (std::size_t i = 0; i < holidays.list.size(); ++i) {
    const std::string* c = &at[4 * i];
    text += fmt::format(R"({}{{"type":"Feature","properties":{},"geometry":{{"type":"Polygon",)"
                        R"("coordinates":[[{},{},{},{},{}]]}}}})",
                        i == 0 ? "\n" : ",\n", properties(holidays.list[i], i + 1, frame), c[0],
                        c[1], c[2], c[3], c[0]);
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

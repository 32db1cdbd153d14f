#include "io/files/geojson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    if (conversion.known()) {
      out.push_back(geojson_lonlat(lonlat[i]));
      continue;
    }
    const Vec2 p = frame.to_file(local[i]);
    out.push_back(fmt::format("[{},{}]", decimal(p.x(), 6), decimal(p.y(), 6)));
  }
  return out;
}

namespace {

double latitude_at_180(const Vec2& from, const Vec2& unwrapped_to, double side) {
  const double share = (side - from.x()) / (unwrapped_to.x() - from.x());
  return from.y() + share * (unwrapped_to.y() - from.y());
}

/// What of a ring lies on one side of the meridian `lon`, by Sutherland and Hodgman.
std::vector<Vec2> clipped(const std::vector<Vec2>& ring, double lon, bool west) {
  const auto inside = [&](const Vec2& p) { return west ? p.x() <= lon : p.x() >= lon; };
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % ring.size()];
    if (inside(a)) result.push_back(a);
    if (inside(a) != inside(b) && a.x() != lon && b.x() != lon) {
      result.emplace_back(lon, latitude_at_180(a, b, lon));
    }
  }
  return result;
}

double extent_in_longitude(const std::vector<Vec2>& ring) {
  const auto [low, high] = std::minmax_element(
      ring.begin(), ring.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  return high->x() - low->x();
}

}  // namespace

std::vector<std::vector<CutPlace>> cut_at_180(const std::vector<Vec2>& line) {
  std::vector<Vec2> lonlat = line;
  for (std::size_t i = 1; i < lonlat.size(); ++i) {
    // 180 and -180 are one place: from there to there is no way around the world.
    if (std::abs(lonlat[i].x() - lonlat[i - 1].x()) == 360.0) lonlat[i].x() = lonlat[i - 1].x();
  }
  std::vector<std::vector<CutPlace>> parts(1);
  for (std::size_t i = 0; i < lonlat.size(); ++i) {
    parts.back().push_back({lonlat[i], i});
    if (i + 1 == lonlat.size()) break;
    const double step = lonlat[i + 1].x() - lonlat[i].x();
    if (std::abs(step) <= 180.0) continue;
    const double side = step < 0.0 ? 180.0 : -180.0;
    const Vec2 to = lonlat[i + 1] + Vec2(2.0 * side, 0.0);
    const double lat =
        to.x() == lonlat[i].x() ? lonlat[i].y() : latitude_at_180(lonlat[i], to, side);
    if (lonlat[i].x() != side) parts.back().push_back({{side, lat}, i});
    // A part of one place is none.
    if (parts.back().size() < 2) parts.pop_back();
    parts.emplace_back();
    if (lonlat[i + 1].x() != -side) parts.back().push_back({{-side, lat}, i});
  }
  if (parts.size() > 1 && parts.back().size() < 2) parts.pop_back();
  return parts;
}

std::vector<std::vector<Vec2>> ring_cut_at_180(const std::vector<Vec2>& lonlat) {
  if (lonlat.empty() || extent_in_longitude(lonlat) <= 180.0) return {lonlat};
  std::vector<Vec2> east = lonlat;
  for (Vec2& p : east) p.x() += p.x() < 0.0 ? 360.0 : 0.0;
  std::vector<std::vector<Vec2>> parts;
  for (const bool west : {true, false}) {
    std::vector<Vec2> part = clipped(east, 180.0, west);
    if (!west) {
      for (Vec2& p : part) p.x() -= 360.0;
    }
    if (part.size() >= 3) parts.push_back(std::move(part));
  }
  return parts;
}

std::string geojson_lonlat(const Vec2& lonlat) {
  constexpr int kMicrometre = 11;  // decimals: finer than curves need
  return fmt::format("[{},{}]", decimal(lonlat.x(), kMicrometre), decimal(lonlat.y(), kMicrometre));
}

std::string geojson_name(const std::string& stem, const Frame& frame) {
  return stem + (frame.crs_wkt.empty() ? ".local.geojson" : ".geojson");
}

}  // namespace swathplan

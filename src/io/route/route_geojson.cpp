#include "io/route/route_geojson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
#include "io/files/lonlat.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// A leg or, where it crosses 180 degrees, a part of it: its positions, and the waypoint whose row
/// holds for each of its segments.
struct LegPart {
  std::vector<std::string> positions;
  std::vector<std::size_t> segments;
};

std::vector<LegPart> parts_of(const Leg& leg, const std::vector<std::string>& at,
                              const std::vector<Vec2>& lonlat) {
  std::vector<LegPart> parts;
  if (lonlat.empty()) {
    LegPart& whole = parts.emplace_back();
    for (std::size_t i = leg.first; i <= leg.last; ++i) {
      whole.positions.push_back(at[i]);
      if (i < leg.last) whole.segments.push_back(i);
    }
    return parts;
  }
  const auto begin = lonlat.begin();
  for (const std::vector<CutPlace>& cut :
       cut_at_180({begin + static_cast<std::ptrdiff_t>(leg.first),
                   begin + static_cast<std::ptrdiff_t>(leg.last) + 1})) {
    LegPart& part = parts.emplace_back();
    for (std::size_t k = 0; k < cut.size(); ++k) {
      part.positions.push_back(geojson_lonlat(cut[k].lonlat));
      if (k + 1 < cut.size()) part.segments.push_back(leg.first + cut[k].segment);
    }
  }
  return parts;
}

/// `value(waypoint)` of each segment of the part under `name`; one figure where all agree, else the
/// first and the whole list.
template <class Value>
void add_per_point(OrderedJson& properties, const std::string& name, const Route& route,
                   const LegPart& part, Value value) {
  OrderedJson list = OrderedJson::array();
  bool same = true;
  for (const std::size_t i : part.segments) {
    list.push_back(value(route.waypoints[i]));
    same = same && list.back() == list.front();
  }
  properties[name] = list.front();
  if (!same) properties[name + "_at_points"] = std::move(list);
}

OrderedJson angle(const std::optional<FanAngles>& fan, Angle FanAngles::*side) {
  if (!fan) return nullptr;
  return std::round(((*fan).*side).deg() * 1e6) / 1e6;
}

OrderedJson properties(const Route& route, const Leg& leg, const LegPart& part, std::size_t index) {
  const Waypoint& w = route.waypoints[leg.first];
  OrderedJson p;
  p["leg"] = index;
  p["line"] = w.line ? OrderedJson(*w.line) : OrderedJson(nullptr);
  p["kind"] = name(w.kind);
  p["log"] = w.log ? 1 : 0;
  add_per_point(p, "port_deg", route, part,
                [](const Waypoint& at) { return angle(at.fan, &FanAngles::port); });
  add_per_point(p, "stbd_deg", route, part,
                [](const Waypoint& at) { return angle(at.fan, &FanAngles::starboard); });
  add_per_point(p, "speed_mps", route, part,
                [](const Waypoint& at) { return OrderedJson(at.speed_mps); });
  p["region"] = w.region ? OrderedJson(*w.region) : OrderedJson(nullptr);
  p["status"] = w.feasible ? OrderedJson(nullptr) : OrderedJson("infeasible");
  return p;
}

}  // namespace

std::string route_geojson(const Route& route, const Frame& frame) {
  std::vector<Vec2> local;
  for (const Waypoint& w : route.waypoints) local.push_back(w.position);
  const LonLat conversion(frame);
  std::vector<Vec2> lonlat;
  std::vector<std::string> at;
  if (conversion.known()) {
    lonlat = conversion.from_local(local);
  } else {
    at = geojson_positions(local, frame);
  }
  std::string text = geojson_head(frame);
  const std::vector<Leg> all = legs(route);
  bool first = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const LegPart& part : parts_of(all[i], at, lonlat)) {
      text += fmt::format(R"({}{{"type":"Feature","properties":{},"geometry":{{"type":)"
                          R"("LineString","coordinates":[{}]}}}})",
                          first ? "\n" : ",\n", properties(route, all[i], part, i).dump(),
                          fmt::join(part.positions, ","));
      first = false;
    }
  }
  return text + geojson_tail();
}

std::filesystem::path write_route_geojson(const std::filesystem::path& folder, const Route& route,
                                          const Frame& frame) {
  if (const auto why = fault(route)) throw InvalidInput("the route cannot be written: " + *why);
  std::filesystem::path path = folder / geojson_name("route", frame);
  write_text_atomically(path, route_geojson(route, frame));
  return path;
}

}  // namespace swathplan

#include "io/route/route_geojson.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/files/geojson.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// `value(waypoint)` of each segment of the leg under `name`; one figure where all agree, else the
/// first and the whole list.
template <class Value>
void add_per_point(OrderedJson& properties, const std::string& name, const Route& route,
                   const Leg& leg, Value value) {
  OrderedJson list = OrderedJson::array();
  bool same = true;
  for (std::size_t i = leg.first; i < leg.last; ++i) {
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

OrderedJson properties(const Route& route, const Leg& leg, std::size_t index) {
  const Waypoint& w = route.waypoints[leg.first];
  OrderedJson p;
  p["leg"] = index;
  p["line"] = w.line ? OrderedJson(*w.line) : OrderedJson(nullptr);
  p["kind"] = name(w.kind);
  p["log"] = w.log ? 1 : 0;
  add_per_point(p, "port_deg", route, leg,
                [](const Waypoint& at) { return angle(at.fan, &FanAngles::port); });
  add_per_point(p, "stbd_deg", route, leg,
                [](const Waypoint& at) { return angle(at.fan, &FanAngles::starboard); });
  add_per_point(p, "speed_mps", route, leg,
                [](const Waypoint& at) { return OrderedJson(at.speed_mps); });
  p["region"] = w.region ? OrderedJson(*w.region) : OrderedJson(nullptr);
  p["status"] = w.feasible ? OrderedJson(nullptr) : OrderedJson("infeasible");
  return p;
}

}  // namespace

std::string route_geojson(const Route& route, const Frame& frame) {
  std::vector<Vec2> local;
  for (const Waypoint& w : route.waypoints) local.push_back(w.position);
  const std::vector<std::string> at = geojson_positions(local, frame);
  std::string text = geojson_head(frame);
  const std::vector<Leg> all = legs(route);
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += fmt::format(R"({}{{"type":"Feature","properties":{},"geometry":{{"type":)"
                        R"("LineString","coordinates":[)",
                        i == 0 ? "\n" : ",\n", properties(route, all[i], i).dump());
    for (std::size_t k = all[i].first; k <= all[i].last; ++k) {
      text += (k == all[i].first ? "" : ",") + at[k];
    }
    text += "]}}";
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

#include "io/exports/mission_plan.h"

#include <fmt/format.h>

#include <iterator>

#include "io/exports/mission_waypoints.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

constexpr const char* kHead = R"({{
"fileType":"Plan",
"version":1,
"groundStation":"swathplan",
"geoFence":{{"circles":[],"polygons":[],"version":2}},
"rallyPoints":{{"points":[],"version":2}},
"mission":{{
"version":2,
"firmwareType":3,
"vehicleType":11,
"globalPlanAltitudeMode":1,
"cruiseSpeed":{0},
"hoverSpeed":{0},
"plannedHomePosition":[{1:.8f},{2:.8f},0],
"items":[)";

/// Frame 3: altitude relative to home. Frame 2: a command without a place.
constexpr const char* kPlace =
    R"({{"type":"SimpleItem","doJumpId":{},"autoContinue":true,"command":16,"frame":3,)"
    R"("AltitudeMode":1,"Altitude":0,"AMSLAltAboveTerrain":null,)"
    R"("params":[0,0,0,null,{:.8f},{:.8f},0]}})";
constexpr const char* kSpeed =
    R"({{"type":"SimpleItem","doJumpId":{},"autoContinue":true,"command":178,"frame":2,)"
    R"("params":[1,{},-1,0,0,0,0]}})";

}  // namespace

std::string mission_plan(const GeographicRoute& route) {
  const Vec2& home = route.lonlat.front();
  std::string text = fmt::format(
      fmt::runtime(kHead), decimal(route.route.waypoints.front().speed_mps, 3), home.y(), home.x());
  std::size_t number = 0;
  for (const MissionItem& item : mission_items(route, 0, route.lonlat.size() - 1)) {
    text += number++ == 0 ? "\n" : ",\n";
    if (item.speed_mps) {
      text += fmt::format(fmt::runtime(kSpeed), number, decimal(*item.speed_mps, 3));
    } else {
      text += fmt::format(fmt::runtime(kPlace), number, item.lonlat.y(), item.lonlat.x());
    }
  }
  return text + "\n]}\n}\n";
}

}  // namespace swathplan

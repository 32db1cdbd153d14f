#include "io/exports/mission_waypoints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "io/exports/survey_runs.h"
#include "io/files/text.h"

namespace swathplan {
namespace {

// MAV_CMD and MAV_FRAME of MAVLink's common message set.
constexpr int kNavWaypoint = 16;
constexpr int kDoChangeSpeed = 178;
constexpr int kGlobal = 0;
constexpr int kGlobalRelativeAltitude = 3;
constexpr int kGroundSpeed = 1;
constexpr int kThrottleUnchanged = -1;

/// The first and the last waypoint of each mission.
using Part = std::pair<std::size_t, std::size_t>;

bool speed_changes(const Route& route, std::size_t i, std::size_t first) {
  return i == first || route.waypoints[i].speed_mps != route.waypoints[i - 1].speed_mps;
}

std::string waypoint(std::size_t index, int current, int frame, const Vec2& lonlat) {
  return fmt::format("{}\t{}\t{}\t{}\t0\t0\t0\t0\t{:.8f}\t{:.8f}\t0\t1\n", index, current, frame,
                     kNavWaypoint, lonlat.y(), lonlat.x());
}

Mission mission(const GeographicRoute& route, const Part& part) {
  const auto [first, last] = part;
  Mission result{"QGC WPL 110\n" + waypoint(0, 1, kGlobal, route.lonlat[first]), 1};
  for (const MissionItem& item : mission_items(route, first, last)) {
    if (item.speed_mps) {
      result.text += fmt::format("{}\t0\t{}\t{}\t{}\t{}\t{}\t0\t0\t0\t0\t1\n", result.items++,
                                 kGlobalRelativeAltitude, kDoChangeSpeed, kGroundSpeed,
                                 decimal(*item.speed_mps, 3), kThrottleUnchanged);
    } else {
      result.text += waypoint(result.items++, 0, kGlobalRelativeAltitude, item.lonlat);
    }
  }
  return result;
}

/// The last waypoint that a mission from `first` has room for.
std::size_t farthest(const Route& route, std::size_t first, std::size_t most_items) {
  std::size_t items = 3;  // home, speed, first waypoint
  std::size_t last = first;
  while (last + 1 < route.waypoints.size()) {
    items += last > first && speed_changes(route, last, first) ? 2 : 1;
    if (items > most_items) break;
    ++last;
  }
  return last;
}

std::vector<Part> parts_of(const Route& route, std::size_t most_items) {
  const std::size_t end = route.waypoints.size() - 1;
  if (most_items == 0) return {{0, end}};
  assert(most_items >= kFewestItems);
  std::vector<bool> ends_line(route.waypoints.size(), false);
  for (const SurveyRun& run : survey_runs(route)) ends_line[run.last] = true;
  std::vector<Part> parts;
  for (std::size_t first = 0; first < end;) {
    const std::size_t reach = farthest(route, first, most_items);
    // A shorter mission is better than a line cut in two, but not one less than half as long.
    const std::size_t shortest = first + std::max<std::size_t>(1, (reach - first) / 2);
    std::size_t last = reach;
    while (reach < end && last > shortest && !ends_line[last]) --last;
    if (!ends_line[last]) last = reach;
    parts.emplace_back(first, last);
    first = last;
  }
  return parts;
}

}  // namespace

std::vector<MissionItem> mission_items(const GeographicRoute& route, std::size_t first,
                                       std::size_t last) {
  std::vector<MissionItem> items;
  for (std::size_t i = first; i <= last; ++i) {
    // A speed that is set before a waypoint holds on the way to it.
    const std::size_t leg = i == first ? first : i - 1;
    if (i != first + 1 && speed_changes(route.route, leg, first)) {
      items.push_back({.speed_mps = route.route.waypoints[leg].speed_mps});
    }
    items.push_back({.speed_mps = std::nullopt, .lonlat = route.lonlat[i]});
  }
  return items;
}

std::vector<Mission> mission_waypoints(const GeographicRoute& route, std::size_t most_items) {
  std::vector<Mission> missions;
  for (const Part& part : parts_of(route.route, most_items)) {
    missions.push_back(mission(route, part));
  }
  return missions;
}

}  // namespace swathplan

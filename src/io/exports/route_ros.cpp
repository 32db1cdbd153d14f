#include "io/exports/route_ros.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/files/crs.h"

namespace swathplan {
namespace {

/// Radians counter-clockwise from east. The last pose looks as the one before.
double yaw_at(const Route& route, std::size_t i) {
  const auto& w = route.waypoints;
  for (std::size_t k = std::min(i, w.size() - 2) + 1; k-- > 0;) {
    const Vec2 way = w[k + 1].position - w[k].position;
    if (way.norm() > 0.0) return std::atan2(way.y(), way.x());
  }
  return 0.0;
}

}  // namespace

std::string route_ros(const Route& route, const Frame& frame) {
  std::string text = fmt::format(
      "# nav_msgs/msg/Path: metres east and north of {}\n"
      "header:\n  stamp: {{sec: 0, nanosec: 0}}\n  frame_id: map\nposes:\n",
      frame.crs_wkt.empty() ? "a local origin" : crs_name(frame.crs_wkt));
  for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
    const Vec2 p = frame.to_file(route.waypoints[i].position) * frame.metres_per_unit;
    const double half = 0.5 * yaw_at(route, i);
    fmt::format_to(std::back_inserter(text),
                   "- header: {{stamp: {{sec: 0, nanosec: 0}}, frame_id: map}}\n"
                   "  pose:\n    position: {{x: {:.6f}, y: {:.6f}, z: 0.0}}\n"
                   "    orientation: {{x: 0.0, y: 0.0, z: {:.9f}, w: {:.9f}}}\n",
                   p.x(), p.y(), std::sin(half), std::cos(half));
  }
  return text;
}

}  // namespace swathplan

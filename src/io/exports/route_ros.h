#pragma once

#include <string>

#include "coverage/route/route.h"

namespace swathplan {

/// The whole route as YAML of a ROS 2 message nav_msgs/msg/Path, as `ros2 topic pub` takes it.
/// Positions are metres east and north in the CRS of the input file (z = 0), to a micrometre; the
/// frame is 'map'. A pose looks along the path, x ahead, counter-clockwise from east (REP 103). The
/// first line of text, a comment, names the CRS.
[[nodiscard]] std::string route_ros(const Route& route, const Frame& frame);

}  // namespace swathplan

#pragma once

#include <string>
#include <string_view>

#include "io/route/foreign_route.h"

namespace swathplan {

/// True for YAML that lists poses, as a nav_msgs/Path of ROS does.
[[nodiscard]] bool is_ros_path(std::string_view text);

/// Reads the positions of its poses: metres in the CRS of the seafloor's file, whose unit is
/// `metres_per_unit`. Orientations and heights are passed over.
/// @throws InvalidInput for a pose without x and y, which it counts out.
[[nodiscard]] ForeignRoute parse_route_ros(std::string_view text, const std::string& file,
                                           double metres_per_unit);

}  // namespace swathplan

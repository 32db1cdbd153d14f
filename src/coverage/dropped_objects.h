#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/seafloor.h"

namespace swathplan {

enum class ObjectShape { sphere, cylinder, box };

/// A thing that lies on the seafloor.
struct DroppedObject {
  ObjectShape shape = ObjectShape::sphere;
  Vec3 base = Vec3::Zero();  ///< where it touches the seafloor
  double size_m = 1.0;       ///< diameter of a sphere or a lying cylinder, height of a box
  double length_m = 1.0;     ///< of a cylinder or box along its axis; a box is size x length x size
  Angle heading = {};        ///< of that axis, clockwise from north
};

/// The object's top and outermost points, local metres: what a sonar has to see of it.
[[nodiscard]] Vec3 top(const DroppedObject& object);

/// The seafloor with the objects' surfaces added, each a closed body sunk 5 cm into the bottom.
/// Below their widest level spheres and cylinders go straight down: no overhang, and the same
/// shadow from a sonar above them.
[[nodiscard]] Seafloor with_objects(const Seafloor& seafloor,
                                    const std::vector<DroppedObject>& objects);

}  // namespace swathplan

#pragma once

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

/// The highest point of the object, local metres. A sonar has to see this point. The surface that
/// `with_objects` makes of a sphere ends 1.7 % of its diameter below it.
[[nodiscard]] Vec3 top(const DroppedObject& object);

/// The seafloor with the surfaces of the objects added. Each is a closed body whose flat underside
/// lies 5 cm below its base point, so on a steep slope an edge of it can stand clear of the bottom.
/// Below their widest level spheres and cylinders go straight down, without an overhang. Seen from
/// above that level their shadow ends where that of the true shape ends. On the sonar's side the
/// bottom below the widest level is hidden, where the true shape would leave some of it in sight.
/// The result is for tracing rays only: it is not repaired, and undersides look down.
/// Sizes are not checked.
[[nodiscard]] Seafloor with_objects(const Seafloor& seafloor,
                                    const std::vector<DroppedObject>& objects);

}  // namespace swathplan

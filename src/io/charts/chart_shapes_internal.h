#pragma once

#include <ogr_geometry.h>

#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// The parts of a feature's geometry, in its file's coordinates.
struct ChartShapes {
  std::vector<std::vector<Ring>> polygons;  ///< each as its rings
  std::vector<std::vector<Vec2>> lines;
  std::vector<Vec3> points;
  [[nodiscard]] bool empty() const { return polygons.empty() && lines.empty() && points.empty(); }
};

/// Takes a geometry apart; nothing of an empty one, or of none. Places that are not finite are left
/// out with their part.
[[nodiscard]] ChartShapes shapes_of(const OGRGeometry* geometry);

/// All plane positions of the parts, to be changed in place.
template <class Use>
void for_each_position(ChartShapes& shapes, Use use) {
  for (auto& rings : shapes.polygons) {
    for (Ring& ring : rings) use(ring);
  }
  for (auto& line : shapes.lines) use(line);
  for (Vec3& point : shapes.points) {
    std::vector<Vec2> one{point.head<2>()};
    use(one);
    point.head<2>() = one.front();
  }
}

}  // namespace swathplan

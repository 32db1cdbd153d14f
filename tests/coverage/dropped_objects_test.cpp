#include "coverage/dropped_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesh/synthetic.h"

namespace swathplan {
namespace {

double volume(const Seafloor& mesh, std::size_t first_face) {
  double sum = 0.0;
  for (std::size_t f = first_face; f < mesh.faces.size(); ++f) {
    const auto& v = mesh.faces[f];
    sum += mesh.vertices[v[0]].dot(mesh.vertices[v[1]].cross(mesh.vertices[v[2]])) / 6.0;
  }
  return sum;
}

// Closed and facing outward: the signed volume is the body's own.
TEST(DroppedObjects, AreClosedBodiesOfTheirSize) {
  const Seafloor bottom = flat(10, 10, 5.0);
  const double pi = 3.14159265;
  const auto body = [&](DroppedObject o) {
    o.base = {5, 5, -5};
    return volume(with_objects(bottom, {o}), bottom.faces.size());
  };
  EXPECT_NEAR(body({ObjectShape::box, {}, 1.0, 2.0, Angle::degrees(30)}), 2.0 * 1.05, 1e-9);
  const double sphere = 0.5 * 4.0 / 3.0 * pi * 0.125 + pi * 0.25 * 0.55;
  EXPECT_NEAR(body({ObjectShape::sphere, {}, 1.0, 1.0, {}}), sphere, 0.03 * sphere);
  const double cylinder = 2.0 * (0.5 * pi * 0.25 + 1.0 * 0.55);
  EXPECT_NEAR(body({ObjectShape::cylinder, {}, 1.0, 2.0, Angle::degrees(70)}), cylinder,
              0.03 * cylinder);
}

TEST(DroppedObjects, LeaveTheSeafloorAsItWas) {
  const Seafloor bottom = flat(10, 10, 5.0);
  EXPECT_EQ(with_objects(bottom, {}).faces, bottom.faces);
  const DroppedObject o{ObjectShape::sphere, Vec3(5, 5, -5), 1.0, 1.0, {}};
  EXPECT_EQ(top(o), Vec3(5, 5, -4));
}

TEST(DroppedObjects, HaveNoBorder) {
  const Seafloor bottom = flat(10, 10, 5.0);
  for (const ObjectShape shape : {ObjectShape::sphere, ObjectShape::cylinder, ObjectShape::box}) {
    const Seafloor both =
        with_objects(bottom, {{shape, Vec3(5, 5, -5), 1.0, 2.0, Angle::degrees(20)}});
    // Each edge is run once in either sense.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs;
    for (std::size_t f = bottom.faces.size(); f < both.faces.size(); ++f) {
      const auto& face = both.faces[f];
      for (std::size_t i = 0; i < 3; ++i) ++runs[{face.at(i), face.at((i + 1) % 3)}];
    }
    for (const auto& [edge, count] : runs) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(runs.contains({edge.second, edge.first}));
    }
  }
}

TEST(DroppedObjects, LieAlongTheirHeadingAndReachUpToTheirTop) {
  const Seafloor bottom = flat(20, 20, 5.0);
  for (const ObjectShape shape : {ObjectShape::sphere, ObjectShape::cylinder, ObjectShape::box}) {
    const DroppedObject o{shape, Vec3(10, 10, -5), 1.0, 4.0, Angle::degrees(90)};
    const Seafloor both = with_objects(bottom, {o});
    Vec3 low = both.vertices.back();
    Vec3 high = low;
    for (std::size_t v = bottom.vertices.size(); v < both.vertices.size(); ++v) {
      low = low.cwiseMin(both.vertices[v]);
      high = high.cwiseMax(both.vertices[v]);
    }
    const bool sphere = shape == ObjectShape::sphere;
    EXPECT_NEAR(high.x() - low.x(), sphere ? 1.0 : 4.0, 1e-9);  // heading east
    EXPECT_NEAR(high.y() - low.y(), 1.0, 1e-9);
    EXPECT_NEAR(low.z(), -5.05, 1e-9);
    EXPECT_NEAR(high.z(), top(o).z(), sphere ? 0.0175 : 1e-9);
  }
}

}  // namespace
}  // namespace swathplan

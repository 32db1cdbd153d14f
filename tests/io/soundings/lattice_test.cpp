#include "io/soundings/lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/seafloor/surface_area.h"

namespace swathplan {
namespace {

/// Nodes of 12 x 8 places with steps of 2 and 3, in no order of rows.
SurfaceData lattice_of_nodes() {
  SurfaceData data;
  for (int i = 11; i >= 0; --i) {
    for (int j = 0; j < 8; ++j) data.vertices.emplace_back(100.0 + 2.0 * i, 50.0 + 3.0 * j, -5.0);
  }
  return data;
}

TEST(Lattice, JoinsItsNodesAsAGridDoes) {
  SurfaceData data = lattice_of_nodes();
  ASSERT_TRUE(join_lattice(data));
  EXPECT_TRUE(data.is_clean);
  EXPECT_EQ(data.faces.size(), 2U * 11 * 7);
  EXPECT_TRUE(test::all_faces_look_up(data));
  EXPECT_DOUBLE_EQ(test::plan_area(data), 22.0 * 21.0);
  EXPECT_DOUBLE_EQ(data.spacing, std::sqrt(6.0));
}

TEST(Lattice, AMissingNodeLeavesAHole) {
  SurfaceData data = lattice_of_nodes();
  data.vertices.erase(data.vertices.begin() + 8 * 5 + 3);  // inside: four cells have it as corner
  ASSERT_TRUE(join_lattice(data));
  EXPECT_DOUBLE_EQ(test::plan_area(data), 22.0 * 21.0 - 4 * 6.0);
}

TEST(Lattice, RefusesScatteredTurnedAndDoubledPoints) {
  SurfaceData scattered = lattice_of_nodes();
  scattered.vertices[20].x() += 0.7;
  EXPECT_FALSE(join_lattice(scattered));
  SurfaceData turned = lattice_of_nodes();
  for (Vec3& v : turned.vertices)
    v = Vec3(0.8 * v.x() - 0.6 * v.y(), 0.6 * v.x() + 0.8 * v.y(), -5);
  EXPECT_FALSE(join_lattice(turned));
  SurfaceData doubled = lattice_of_nodes();
  doubled.vertices.push_back(doubled.vertices.front());
  EXPECT_FALSE(join_lattice(doubled));
  EXPECT_TRUE(doubled.faces.empty());
}

}  // namespace
}  // namespace swathplan

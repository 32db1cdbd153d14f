#include <gtest/gtest.h>

#include <cmath>

#include "mesh/repair/mesh_repair.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

TEST(MeshAssessment, CountsPartsHolesAndWalls) {
  Seafloor s = flat(10, 10, 5);
  const std::size_t faces = s.faces.size();
  EXPECT_EQ(assess(s).boundary_loops, 1U);
  // A hole: both faces of one cell that does not touch the border.
  std::erase_if(s.faces, [&](const Seafloor::Face& f) {
    const Vec3 middle = (s.vertices[f[0]] + s.vertices[f[1]] + s.vertices[f[2]]) / 3.0;
    return std::floor(middle.x()) == 4.0 && std::floor(middle.y()) == 4.0;
  });
  ASSERT_EQ(s.faces.size(), faces - 2);
  EXPECT_EQ(assess(s).boundary_loops, 2U);
  EXPECT_EQ(assess(s).components, 1U);
  // A second part, far off.
  const auto first = static_cast<std::uint32_t>(s.vertices.size());
  s.vertices.insert(s.vertices.end(), {Vec3(90, 0, -1), Vec3(91, 0, -1), Vec3(90, 1, -1)});
  s.faces.push_back({first, first + 1, first + 2});
  EXPECT_EQ(assess(s).components, 2U);
  EXPECT_EQ(assess(s).boundary_loops, 3U);
}

TEST(MeshAssessment, CountsWallsAndEdgesOfManyFacesWithoutMendingThem) {
  Seafloor s;
  s.vertices = {{0, 0, -5}, {4, 0, -5}, {4, 4, -5}, {0, 4, -5}, {0, 0, -9}, {2, -3, -7}};
  s.faces = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};  // the third hangs from the edge 0-1
  const MeshHealth plain = assess(s);
  EXPECT_EQ(plain.faces, 3U);
  EXPECT_EQ(plain.vertices, 6U);
  EXPECT_EQ(plain.vertical_faces, 1U);
  EXPECT_EQ(plain.non_manifold_edges, 0U);
  EXPECT_EQ(plain.components, 1U);
  s.faces.push_back({0, 5, 1});
  EXPECT_EQ(assess(s).non_manifold_edges, 1U);
  EXPECT_EQ(s.faces.size(), 4U);
}

}  // namespace
}  // namespace swathplan

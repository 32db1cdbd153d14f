#include <gtest/gtest.h>

#include "mesh/repair/closed_bodies_internal.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

/// A unit cube between z = -3 and z = -2, all faces outwards; the last two are its top.
Seafloor closed_cube() {
  Seafloor cube;
  for (const double z : {-3.0, -2.0}) {
    cube.vertices.insert(cube.vertices.end(), {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
  }
  cube.faces = {{0, 2, 1}, {0, 3, 2}};
  for (std::uint32_t a = 0; a < 4; ++a) {
    const std::uint32_t b = (a + 1) % 4;
    cube.faces.push_back({a, b, b + 4});
    cube.faces.push_back({a, b + 4, a + 4});
  }
  cube.faces.push_back({4, 5, 6});
  cube.faces.push_back({4, 6, 7});
  return cube;
}

void turn_over(Seafloor::Face& face) { std::swap(face[1], face[2]); }

TEST(ClosedBodies, OfACubeOnlyTheTopIsLeft) {
  Seafloor cube = closed_cube();
  const std::vector<Seafloor::Face> top(cube.faces.end() - 2, cube.faces.end());
  EXPECT_EQ(drop_undersides(cube), 10U);
  EXPECT_EQ(cube.faces, top);
}

TEST(ClosedBodies, ABodyTurnedInsideOutLosesTheSameFaces) {
  Seafloor cube = closed_cube();
  for (Seafloor::Face& face : cube.faces) turn_over(face);
  EXPECT_EQ(drop_undersides(cube), 10U);
  ASSERT_EQ(cube.faces.size(), 2U);
  for (const Seafloor::Face& face : cube.faces) {
    for (const std::uint32_t v : face) EXPECT_EQ(cube.vertices[v].z(), -2.0);
  }
}

TEST(ClosedBodies, FacesOfMixedSenseAreMadeToAgreeFirst) {
  for (std::size_t turned = 0; turned < 12; ++turned) {
    Seafloor cube = closed_cube();
    turn_over(cube.faces[turned]);
    EXPECT_EQ(drop_undersides(cube), 10U) << turned;
    for (const Seafloor::Face& face : cube.faces) {
      for (const std::uint32_t v : face) EXPECT_EQ(cube.vertices[v].z(), -2.0) << turned;
    }
  }
}

TEST(ClosedBodies, OpenPartsStayAsTheyAre) {
  Seafloor cube = closed_cube();
  cube.faces.pop_back();  // a hole in the top
  const auto before = cube.faces;
  EXPECT_EQ(drop_undersides(cube), 0U);
  EXPECT_EQ(cube.faces, before);
  Seafloor sheet = flat(3, 3, 5);
  const auto faces = sheet.faces;
  EXPECT_EQ(drop_undersides(sheet), 0U);
  EXPECT_EQ(sheet.faces, faces);
}

TEST(ClosedBodies, ABodyBesideASheetIsTakenApartAlone) {
  Seafloor mesh = flat(3, 3, 5);
  const auto sheet = mesh.faces;
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  const Seafloor cube = closed_cube();
  mesh.vertices.insert(mesh.vertices.end(), cube.vertices.begin(), cube.vertices.end());
  for (const Seafloor::Face& f : cube.faces)
    mesh.faces.push_back({f[0] + base, f[1] + base, f[2] + base});
  EXPECT_EQ(drop_undersides(mesh), 10U);
  ASSERT_EQ(mesh.faces.size(), sheet.size() + 2);
  EXPECT_TRUE(std::equal(sheet.begin(), sheet.end(), mesh.faces.begin()));
}

}  // namespace
}  // namespace swathplan

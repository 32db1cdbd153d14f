#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/import_files.h"
#include "io/seafloor/polygon_soup_internal.h"
#include "io/seafloor/surface_area.h"

namespace swathplan {
namespace {

TEST(TriangulateSoup, PolygonsKeepTheirOutline) {
  // An L: a fan from its first corner would leave it.
  SurfaceData data;
  data.vertices = {Vec3(0, 0, -1), Vec3(4, 0, -1), Vec3(4, 1, -1),
                   Vec3(1, 1, -1), Vec3(1, 4, -1), Vec3(0, 4, -1)};
  data.faces = triangulate("l.obj", data.vertices, {{2, 3, 4, 5, 0, 1}});
  EXPECT_EQ(data.faces.size(), 4U);
  EXPECT_DOUBLE_EQ(test::plan_area(data), 7.0);
  EXPECT_TRUE(test::all_faces_look_up(data));
}

TEST(TriangulateSoup, TrianglesStayAsTheyAre) {
  const std::vector<Vec3> corners{Vec3(0, 0, -1), Vec3(4, 0, -1), Vec3(4, 1, -1)};
  const auto faces = triangulate("t.obj", corners, {{2, 0, 1}});
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces[0], (std::array<std::uint32_t, 3>{2, 0, 1}));
}

TEST(TriangulateSoup, RefusesACornerThatIsNoVertexAndNamesTheFile) {
  const std::vector<Vec3> corners{Vec3(0, 0, -1), Vec3(4, 0, -1), Vec3(4, 1, -1)};
  EXPECT_THAT(refusal([&] {
                return triangulate("t.obj", corners, {{0, 1, 3}});
              }),
              testing::HasSubstr("t.obj"));
}

}  // namespace
}  // namespace swathplan

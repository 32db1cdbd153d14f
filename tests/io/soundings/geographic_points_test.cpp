#include "io/soundings/geographic_points.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

SurfaceData points(std::vector<Vec3> vertices) {
  SurfaceData data;
  data.vertices = std::move(vertices);
  return data;
}

TEST(GeographicPoints, LatitudeBeyondNinetyIsALongitude) {
  SurfaceData data = points({Vec3(52, 170, -8), Vec3(53, 170, -8), Vec3(52, 171, -8)});
  data.faces = {{0, 1, 2}};
  EXPECT_TRUE(mend_geographic_points(data));
  EXPECT_EQ(data.vertices[2], Vec3(171, 52, -8));
  EXPECT_EQ(data.faces[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(data.notes.size(), 1U);
}

TEST(GeographicPoints, LongitudesAcrossTheAntimeridianComeTogether) {
  SurfaceData data = points({Vec3(179.5, 52, -8), Vec3(-179.5, 52, -8), Vec3(-180, 53, -8)});
  EXPECT_TRUE(mend_geographic_points(data));
  EXPECT_EQ(data.vertices[1].x(), 180.5);
  EXPECT_EQ(data.vertices[2].x(), 180.0);
}

TEST(GeographicPoints, OthersStay) {
  for (const Vec3& far : {Vec3(16, 37, -8), Vec3(-16, 37, -8), Vec3(150, 37, -8)}) {
    SurfaceData data = points({Vec3(15, 36, -8), far, Vec3(15, 37, -8)});
    EXPECT_FALSE(mend_geographic_points(data));
    EXPECT_EQ(data.vertices[1], far);
  }
  SurfaceData none;
  EXPECT_FALSE(mend_geographic_points(none));
}

}  // namespace
}  // namespace swathplan

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/seafloor/surface_area.h"
#include "io/soundings/soundings_import.h"

namespace swathplan {
namespace {

TEST(DelaunaySoundings, NoSoundingLiesInTheCircleOfAFace) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  SurfaceData data;
  data.vertices = {Vec3(0, 0, -1), Vec3(100, 0, -1), Vec3(100, 100, -1), Vec3(0, 100, -1)};
  for (int i = 0; i < 500; ++i) data.vertices.emplace_back(place(random), place(random), -5.0);
  const double limit = join_soundings(data, 1000.0);
  EXPECT_EQ(limit, 1000.0);
  EXPECT_TRUE(test::all_faces_look_up(data));
  EXPECT_NEAR(test::plan_area(data), 1e4, 1e-6);
  // Brute force: no point lies inside the circle through the corners of a triangle.
  for (const auto& f : data.faces) {
    const Vec2 a = data.vertices[f[0]].head<2>();
    const Vec2 b = data.vertices[f[1]].head<2>() - a;
    const Vec2 c = data.vertices[f[2]].head<2>() - a;
    const double d = 2.0 * (b.x() * c.y() - b.y() * c.x());
    const Vec2 u((c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / d,
                 (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / d);
    for (const Vec3& v : data.vertices) {
      ASSERT_GE((v.head<2>() - a - u).norm(), u.norm() * (1.0 - 1e-6));
    }
  }
}

TEST(DelaunaySoundings, LongestEdgeKeepsBaysOpen) {
  // Two quays of soundings 1 m apart with 3 m of land between them.
  SurfaceData data;
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      data.vertices.emplace_back(i, j, -5);
      data.vertices.emplace_back(i + 12, j, -5);
    }
  }
  SurfaceData bridged = data;
  join_soundings(bridged, 10.0);
  EXPECT_NEAR(test::plan_area(bridged), 21.0 * 9.0, 1e-9);
  const double limit = join_soundings(data, {});
  EXPECT_GT(limit, std::sqrt(2.0));
  EXPECT_LT(limit, 2.0);
  EXPECT_NEAR(test::plan_area(data), 2.0 * 81.0, 1e-9);
}

TEST(DelaunaySoundings, StraysAreLeftApart) {
  SurfaceData data;
  for (int i = 0; i < 400; ++i) data.vertices.emplace_back(i % 20, i / 20 + 0.1 * (i % 3), -5);
  for (int i = 0; i < 3; ++i) data.vertices.emplace_back(4500 + i, 4500 + i % 2, -5);
  join_soundings(data, {});
  EXPECT_EQ(data.vertices.size(), 400U);
  EXPECT_THAT(data.warnings, testing::Contains(testing::HasSubstr("3 soundings")));
}

}  // namespace
}  // namespace swathplan

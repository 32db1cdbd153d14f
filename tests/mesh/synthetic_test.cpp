#include "mesh/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

TEST(Synthetic, SaddleFollowsItsFormula) {
  const Seafloor floor = saddle();
  EXPECT_EQ(floor.vertices.size(), 81U * 81U);
  for (const Vec3& v : floor.vertices) {
    EXPECT_NEAR(v.z(), (v.x() * v.x() - v.y() * v.y()) / 64.0 - 35.0, 5.1e-4);
  }
}

TEST(Synthetic, HarbourIsAHarbour) {
  const Seafloor floor = harbour();
  const DepthRange range = depth_range(floor);
  EXPECT_NEAR(range.min, 3.0, 0.5);
  EXPECT_NEAR(range.max, 26.0, 0.5);
  const Vec2 size = extent(floor).size();
  EXPECT_NEAR(size.x(), 300, 20);
  EXPECT_NEAR(size.y(), 400, 20);
}

TEST(Synthetic, SeaIsWideSmoothAndTwentyToTwoHundredMetresDeep) {
  const Seafloor floor = sea();
  const DepthRange range = depth_range(floor);
  EXPECT_NEAR(range.min, 20.0, 0.3);
  EXPECT_NEAR(range.max, 200.0, 0.3);
  EXPECT_EQ(extent(floor).size(), Vec2(7400.0, 9300.0));
  for (std::uint32_t f = 0; f < floor.faces.size(); ++f) EXPECT_LT(slope(floor, f).deg(), 6.0);
}

TEST(Synthetic, ImpossibleSizesAreRefused) {
  EXPECT_THROW(static_cast<void>(flat(0, 10, 5)), UsageError);
  EXPECT_THROW(static_cast<void>(tilted(10, 10, 5, Angle::degrees(90))), UsageError);
}

TEST(Synthetic, AllOfThemLookUpAndLieUnderTheWater) {
  for (const Seafloor& floor : {saddle(), shaft(), harbour(), flat(20, 7, 4), stepped(30, 20, 8, 5),
                                tilted(20, 20, 4, Angle::degrees(89))}) {
    for (const Vec3& v : floor.vertices) ASSERT_LT(v.z(), 0.0);
    for (const Seafloor::Face& f : floor.faces) {
      const Vec3 a = floor.vertices[f[1]] - floor.vertices[f[0]];
      const Vec3 b = floor.vertices[f[2]] - floor.vertices[f[0]];
      ASSERT_GT(a.cross(b).z(), 0.0);
    }
  }
}

TEST(Synthetic, AShaftIsAPlainWithASquarePit) {
  const Seafloor floor = shaft();
  const DepthQuery depths(floor);
  EXPECT_NEAR(depths.depth({0, 0}).value(), 45.0, 1e-9);
  EXPECT_NEAR(depths.depth({19.8, -19.8}).value(), 45.0, 1e-9);
  EXPECT_NEAR(depths.depth({20.1, 0}).value(), 10.0, 1e-9);
  EXPECT_NEAR(depths.depth({-49, 49}).value(), 10.0, 1e-9);
  EXPECT_EQ(extent(floor).size(), Vec2(100, 100));
}

TEST(Synthetic, AStepHasItsWallAtMidWidth) {
  const Seafloor floor = stepped(60, 30, 10, 25);
  const DepthQuery depths(floor);
  EXPECT_NEAR(depths.depth({29.9, 12}).value(), 10.0, 1e-9);
  EXPECT_NEAR(depths.depth({30.2, 12}).value(), 25.0, 1e-9);
  EXPECT_EQ(extent(floor).size(), Vec2(60, 30));
}

TEST(Synthetic, WideFloorsAreSampledCoarser) {
  EXPECT_EQ(flat(20, 7, 4).vertices.size(), 21U * 8U);
  const Seafloor wide = flat(4000, 1000, 30);
  EXPECT_LE(wide.vertices.size(), 252000U);
  EXPECT_EQ(extent(wide).size(), Vec2(4000, 1000));
}

}  // namespace
}  // namespace swathplan

#include "mesh/seafloor.h"

#include <gtest/gtest.h>

#include <limits>

#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

TEST(DepthQuery, AnswersThePlaneBetweenTheNodes) {
  const Seafloor floor = tilted(50, 30, 5.0, Angle::degrees(20));
  const DepthQuery depths(floor);
  for (double x = 0.3; x < 50; x += 1.7) {
    for (double y = 0.1; y < 30; y += 2.3) {
      // Heights are rounded to a millimetre.
      EXPECT_NEAR(depths.depth({x, y}).value(), 5.0 + std::tan(20 * M_PI / 180) * x, 1e-3);
    }
  }
  EXPECT_FALSE(depths.depth({-0.01, 5}));
  EXPECT_FALSE(depths.depth({25, 30.01}));
  EXPECT_FALSE(depths.depth({std::numeric_limits<double>::quiet_NaN(), 0}));
}

TEST(DepthQuery, EveryVertexAndEdgeHasItsDepth) {
  const Seafloor floor = saddle();
  const DepthQuery depths(floor);
  for (const Vec3& v : floor.vertices) {
    ASSERT_TRUE(depths.depth(v.head<2>()));
    EXPECT_NEAR(*depths.depth(v.head<2>()), -v.z(), 1e-9);
  }
  for (const auto& f : floor.faces) {
    const Vec3 middle = 0.5 * (floor.vertices[f[0]] + floor.vertices[f[2]]);
    EXPECT_NEAR(depths.depth(middle.head<2>()).value(), -middle.z(), 1e-9);
  }
}

TEST(DepthQuery, NearestDepthMatchesALoopOverAllVertices) {
  const Seafloor floor = harbour();
  const DepthQuery depths(floor);
  for (const Vec2& p :
       {Vec2(-50, -20), Vec2(5, 300), Vec2(150, 330), Vec2(232, 62), Vec2(900, 900)}) {
    double best = std::numeric_limits<double>::infinity();
    for (const Vec3& v : floor.vertices) best = std::min(best, (v.head<2>() - p).norm());
    bool found = false;
    for (const Vec3& v : floor.vertices) {
      found = found || ((v.head<2>() - p).norm() <= best + 1e-9 &&
                        std::abs(depths.nearest_depth(p) + v.z()) < 1e-12);
    }
    EXPECT_TRUE(found) << p.transpose();
  }
}

TEST(DepthQuery, TheShoalestOfSeveralLayersCounts) {
  Seafloor floor;
  floor.vertices = {{0, 0, -20}, {10, 0, -20}, {0, 10, -20}, {0, 0, -5}, {10, 0, -5}, {0, 10, -5}};
  floor.faces = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_DOUBLE_EQ(DepthQuery(floor).depth({2, 2}).value(), 5.0);
}

TEST(DepthRange, IsWeightedByPlanArea) {
  const DepthRange range = depth_range(shaft());
  EXPECT_DOUBLE_EQ(range.min, 10.0);
  EXPECT_DOUBLE_EQ(range.max, 45.0);
  // 40 x 40 of 100 x 100 at 45 m, walls 0.1 m wide at their mean.
  EXPECT_NEAR(range.mean, 0.84 * 10 + 0.16 * 45, 0.06);
}

TEST(DepthRange, AVerticalSheetIsRefused) {
  Seafloor sheet;
  sheet.vertices = {{0, 0, -1}, {10, 0, -1}, {10, 0, -5}};
  sheet.faces = {{0, 1, 2}};
  EXPECT_THROW(static_cast<void>(depth_range(sheet)), InvalidInput);
}

TEST(Slope, OfATiltedFloorIsItsTilt) {
  const Seafloor floor = tilted(20, 20, 5.0, Angle::degrees(35));
  EXPECT_NEAR(slope(floor, 7).deg(), 35.0, 0.1);
}

}  // namespace
}  // namespace swathplan

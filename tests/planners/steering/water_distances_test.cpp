#include "planners/steering/water_distances.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/shapes.h"
#include "planners/steering/basin.h"

namespace swathplan {
namespace {

using test::box;

TEST(WaterDistances, OpenWaterIsStraightToEightInAHundred) {
  const SafeWater water(basin(100, 60));
  WaterDistances distances(water);
  const Vec2 goal(80, 50);
  const auto& metres = distances.to(goal);
  for (const Vec2& p : {Vec2(10, 10), Vec2(80, 5), Vec2(20, 50), Vec2(79, 49)}) {
    const double straight = (goal - p).norm();
    EXPECT_GE(distances.from(p, metres), straight - 1e-3);
    EXPECT_LE(distances.from(p, metres), 1.09 * straight + 2.0 * water.cell_m());
  }
}

// Thinner than a cell, the wall must count all the same.
TEST(WaterDistances, GoAroundAWallHoweverThin) {
  const Area area = subtract(basin(300, 200), {{box(149.99, -1, 150.01, 150), {}}});
  const SafeWater water(area);
  ASSERT_GT(water.cell_m(), 0.1);
  WaterDistances distances(water);
  const auto& metres = distances.to({151, 20});
  EXPECT_NEAR(distances.from({149, 20}, metres), 260.0, 5.0);
  EXPECT_NEAR(distances.from({151, 60}, metres), 40.0, 1.0);
}

TEST(WaterDistances, SeparateWatersAreInfinitelyFarApart) {
  const Area area = subtract(basin(100, 60), {{box(50, -1, 50.2, 61), {}}});
  const SafeWater water(area);
  WaterDistances distances(water);
  EXPECT_TRUE(std::isinf(distances.from({20, 20}, distances.to({80, 20}))));
}

}  // namespace
}  // namespace swathplan

#include "planners/steering/water_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::box_area;

TEST(WaterPath, GoesAroundAndNeverAcross) {
  const Area water = subtract(box_area(0, 0, 200, 100), box_area(90, -1, 110, 80));
  const WaterPath paths(water);
  const auto way = paths.find({10, 10}, {190, 10});
  ASSERT_TRUE(way);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < way->size(); ++i) {
    const Vec2& a = (*way)[i];
    const Vec2& b = (*way)[i + 1];
    length += (b - a).norm();
    double inside = 0.0;
    for (const auto& [t0, t1] : clip_segment(water, a, b)) inside += (t1 - t0) * (b - a).norm();
    EXPECT_NEAR(inside, (b - a).norm(), 1e-6);
  }
  // Around the wall's end: two straight ways to (90, 80) and (110, 80).
  const double shortest = 2 * std::hypot(80.0, 70.0) + 20;
  EXPECT_GE(length, shortest - 1e-6);
  EXPECT_LE(length, 1.05 * shortest);
}

TEST(WaterPath, SeparateWatersHaveNone) {
  const WaterPath paths(unite(box_area(0, 0, 50, 50), box_area(60, 0, 100, 50)));
  EXPECT_FALSE(paths.find({10, 10}, {90, 10}));
  const auto straight = paths.find({10, 10}, {40, 40});
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->size(), 2U);
}

}  // namespace
}  // namespace swathplan

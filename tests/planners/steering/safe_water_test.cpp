#include "planners/steering/safe_water.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/shapes.h"
#include "planners/steering/basin.h"

namespace swathplan {
namespace {

using test::box;

Area with_cable() {
  return subtract(basin(100, 60), {{Ring{{20, 10}, {20.3, 10}, {80.3, 50}, {80, 50}}, {}}});
}

TEST(SafeWater, AnswersAsTheOutlineDoes) {
  const Area area = with_cable();
  const AreaQuery outline(area);
  const SafeWater water(area);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-5, 105), y(-5, 65), step(-3, 3);
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a(x(random), y(random));
    const Vec2 b = a + Vec2(step(random), step(random));
    ASSERT_EQ(water.contains(a), outline.contains(a)) << a.transpose();
    const double length = (b - a).norm();
    const bool inside =
        outline.contains(a) &&
        outline.inside_length(a, b) >= length - SafeWater::kDust * std::max(1.0, length);
    ASSERT_EQ(water.holds({a, b}), inside) << a.transpose() << " to " << b.transpose();
  }
}

TEST(SafeWater, WhatIsClearLiesInTheWater) {
  const Area area = with_cable();
  const AreaQuery outline(area);
  const SafeWater water(area);
  std::size_t known = 0;
  for (double x = -1; x < 101; x += 0.37) {
    for (double y = -1; y < 61; y += 0.41) {
      const double clear = water.clear_around({x, y});
      known += clear > 0.0 ? 1 : 0;
      if (clear > 0.0) {
        ASSERT_TRUE(outline.contains({x, y}));
        ASSERT_LE(clear, outline.distance({x, y}));
      }
    }
  }
  EXPECT_GT(known, 30000U);
}

TEST(SafeWater, NoWaterHoldsNothing) {
  const SafeWater none(Area{});
  EXPECT_FALSE(none.contains({0, 0}));
  EXPECT_EQ(none.clear_around({0, 0}), 0.0);
  EXPECT_FALSE(none.holds({{0, 0}, {1, 0}}));
}

}  // namespace
}  // namespace swathplan

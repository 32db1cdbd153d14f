#include "coverage/water/tide.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swathplan {
namespace {

TEST(Tide, IsStraightBetweenNearRows) {
  const Tide tide({{0.0, 1.0}, {3600.0, 2.0}, {7200.0, 0.0}});
  EXPECT_FALSE(tide.by_cosines());
  EXPECT_DOUBLE_EQ(*tide.height_m(0.0), 1.0);
  EXPECT_DOUBLE_EQ(*tide.height_m(1800.0), 1.5);
  EXPECT_DOUBLE_EQ(*tide.height_m(7200.0), 0.0);
  EXPECT_FALSE(tide.height_m(-1.0));
  EXPECT_FALSE(tide.height_m(7201.0));
}

TEST(Tide, FollowsACosineBetweenHighAndLowWaters) {
  const Tide tide({{0.0, 0.5}, {21600.0, 2.5}, {43200.0, 0.5}});
  EXPECT_TRUE(tide.by_cosines());
  EXPECT_NEAR(*tide.height_m(10800.0), 1.5, 1e-12);
  EXPECT_NEAR(*tide.height_m(7200.0), 1.5 - std::cos(M_PI / 3.0), 1e-12);
  // Above the middle for a quarter of the day: from 3 h to 9 h.
  const auto spans = tide.spans_above(1.5);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_NEAR(spans[0].from_s, 10800.0, Tide::kTideStepS);
  EXPECT_NEAR(spans[0].to_s, 32400.0, Tide::kTideStepS);
  EXPECT_TRUE(tide.spans_above(3.0).empty());
  EXPECT_EQ(tide.spans_above(0.0).size(), 1U);
}

}  // namespace
}  // namespace swathplan

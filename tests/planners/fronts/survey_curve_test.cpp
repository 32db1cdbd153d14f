#include "planners/fronts/survey_curve.h"

#include <gtest/gtest.h>

#include <vector>

namespace swathplan {
namespace {

TEST(SurveyCurve, ResampledKeepsEndsAndLengthOnAStraightLine) {
  const SurveyCurve curve = resampled({{{0, 0}, {1, 0}, {7.3, 0}}}, 2.0);
  ASSERT_EQ(curve.points.size(), 5U);  // ceil(7.3 / 2) parts
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(curve.points[i].x(), 7.3 * static_cast<double>(i) / 4.0, 1e-12);
    EXPECT_EQ(curve.points[i].y(), 0.0);
  }
}

TEST(SurveyCurve, SmoothedHalvesASpikeAndKeepsEnds) {
  const SurveyCurve curve = smoothed({{{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 0}}}, 1);
  const std::vector<double> expected{0.0, 0.25, 0.5, 0.25, 0.0};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(curve.points[i].y(), expected[i]);
  EXPECT_EQ(curve.points.front(), Vec2(0, 0));
  EXPECT_EQ(curve.points.back(), Vec2(4, 0));
}

// Catmull-Rom is exact for parabolas, but for the first and the last part.
TEST(SurveyCurve, SplinedFollowsAParabola) {
  SurveyCurve parabola;
  for (int x = 0; x <= 5; ++x) parabola.points.emplace_back(x, x * x);
  const SurveyCurve curve = splined(parabola, 4);
  ASSERT_EQ(curve.points.size(), 21U);
  for (std::size_t i = 4; i <= 16; ++i) {
    const Vec2& p = curve.points[i];
    EXPECT_NEAR(p.x(), 0.25 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(p.y(), p.x() * p.x(), 1e-12);
  }
}

TEST(CutTo, GivesThePartsInside) {
  const AreaQuery area({{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}},
                         {{{4.0, 2.0}, {4.0, 8.0}, {6.0, 8.0}, {6.0, 2.0}}}}});
  const auto parts = cut_to(straight_curve({-3.0, 5.0}, {13.0, 5.0}), area);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].points.front().x(), 0.0, 1e-3);
  EXPECT_NEAR(parts[0].points.back().x(), 4.0, 1e-3);
  EXPECT_NEAR(length_m(parts[1]), 4.0, 2e-3);
  EXPECT_TRUE(cut_to(straight_curve({-3.0, 11.0}, {13.0, 11.0}), area).empty());
}

TEST(SurveyCurve, IsClosedOnlyWhereItEndsAtItsBeginning) {
  EXPECT_TRUE(is_closed({{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}));
  EXPECT_FALSE(is_closed({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  EXPECT_FALSE(is_closed({{{0, 0}, {1, 0}, {0, 0}}}));  // there and back
}

}  // namespace
}  // namespace swathplan

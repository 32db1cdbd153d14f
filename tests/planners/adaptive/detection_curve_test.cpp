#include "planners/adaptive/detection_curve.h"

#include <gtest/gtest.h>

#include "mesh/base/error.h"
#include "planners/adaptive/spacing_missions.h"

namespace swathplan {
namespace {

TEST(DetectionCurve, InterpolatesAndIsZeroOutside) {
  const DetectionCurve curve{{40, 60}, {0.2, 0.6}};
  EXPECT_DOUBLE_EQ(detection(curve, 50), 0.4);
  EXPECT_DOUBLE_EQ(detection(curve, 40), 0.2);
  EXPECT_DOUBLE_EQ(detection(curve, 60), 0.6);
  EXPECT_DOUBLE_EQ(detection(curve, 39.9), 0.0);
  EXPECT_DOUBLE_EQ(detection(curve, 60.1), 0.0);
}

TEST(DetectionCurve, ThresholdCrossesTheFarFlank) {
  EXPECT_DOUBLE_EQ(*admissible_range_m(example_curve(), 0.05), 130.0);
  EXPECT_DOUBLE_EQ(*admissible_range_m(example_curve(), 0.10), 125.0);
  EXPECT_EQ(admissible_range_m(example_curve(), 0.9), std::nullopt);
  EXPECT_THROW((void)admissible_range_m(example_curve(), 0.0), UsageError);
}

TEST(DetectionCurve, ARevivalBeyondAGapDoesNotCount) {
  const DetectionCurve curve{{10, 20, 30, 40}, {0.5, 0.0, 0.0, 0.4}};
  EXPECT_DOUBLE_EQ(*admissible_range_m(curve, 0.25), 15.0);
}

TEST(DetectionCurve, EstimateFindsTheTrueRange) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SpacingWorld world{.trials = 2000, .seed = seed};
    const auto curve = observe_world(world, {0, 0, true});
    EXPECT_NEAR(*admissible_range_m(curve, 0.05), 130.0, 3.0) << seed;
    EXPECT_NEAR(detection(curve, 72.5), 0.466, 0.05) << seed;
  }
}

TEST(DetectionCurve, EstimateIsUnimodal) {
  const DetectionCounts counts{0, 10, {10, 10, 10, 10, 10}, {2, 1, 6, 3, 4}};
  const auto curve = estimated_curve(counts);
  EXPECT_DOUBLE_EQ(curve.p[0], 0.15);
  EXPECT_DOUBLE_EQ(curve.p[1], 0.15);
  EXPECT_DOUBLE_EQ(curve.p[2], 0.6);
  EXPECT_DOUBLE_EQ(curve.p[3], 0.35);
  EXPECT_DOUBLE_EQ(curve.p[4], 0.35);
  EXPECT_DOUBLE_EQ(curve.range_m.back(), 50.0);
}

TEST(DetectionCurve, EstimateRefusesBadCounts) {
  EXPECT_THROW((void)estimated_curve({0, 5, {1, 2}, {1}}), InvalidInput);
  EXPECT_THROW((void)estimated_curve({0, 5, {1, 2}, {1, 3}}), InvalidInput);
  EXPECT_THROW((void)estimated_curve({0, 5, {1, 2}, {1, -1}}), InvalidInput);
  EXPECT_THROW((void)estimated_curve({0, 0, {1, 2}, {1, 1}}), InvalidInput);
  EXPECT_THROW((void)estimated_curve({0, 5, {0, 0}, {0, 0}}), InvalidInput);
  EXPECT_THROW((void)estimated_curve({}), InvalidInput);
}

}  // namespace
}  // namespace swathplan

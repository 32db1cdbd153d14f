#include <gtest/gtest.h>

#include <numbers>

#include "planners/smoothing/smooth_samples_internal.h"

namespace swathplan {
namespace {

/// There, across, and back: two passes beside each other.
LinePoses there_and_back(double apart) {
  return LinePoses({{0, 0}, {100, 0}, {100, apart}, {0, apart}});
}

TEST(SmoothSamples, LieAtEvenStepsOnTheLineFromEndToEnd) {
  const LinePoses line({{0, 0}, {7, 0}, {7, 6}});
  const Samples s = sampled(line, 2.0);
  ASSERT_EQ(s.points.size(), 8U);  // 13 m in seven parts, the nearest to 2 m
  EXPECT_DOUBLE_EQ(s.step, 13.0 / 7.0);
  EXPECT_EQ(s.points.front(), Vec2(0, 0));
  EXPECT_NEAR((s.points.back() - Vec2(7, 6)).norm(), 0.0, 1e-12);
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const double along = s.step * static_cast<double>(i);
    EXPECT_NEAR(s.along[i], along, 1e-12);
    const Vec2 on_line = along <= 7.0 ? Vec2(along, 0) : Vec2(7, along - 7.0);
    EXPECT_NEAR((s.points[i] - on_line).norm(), 0.0, 1e-12);
  }
}

TEST(SmoothSamples, ALineShorterThanAStepKeepsItsEnds) {
  const Samples s = sampled(LinePoses({{0, 0}, {0.5, 0}}), 2.0);
  ASSERT_EQ(s.points.size(), 2U);
  EXPECT_DOUBLE_EQ(s.step, 0.5);
}

TEST(SmoothSamples, InOpenWaterTheRoomIsTheDeviation) {
  SmoothOptions options;
  options.deviation_m = 2.0;
  const Samples s = sampled(LinePoses({{0, 0}, {100, 0}}), 1.6);
  for (const double r : rooms(s, options)) EXPECT_DOUBLE_EQ(r, 2.0 / std::numbers::sqrt2);
}

TEST(SmoothSamples, TwoPassesCannotMeet) {
  SmoothOptions options;
  options.deviation_m = 20.0;
  const double apart = 10.0;
  const Samples s = sampled(there_and_back(apart), 1.6);
  const std::vector<double> room = rooms(s, options);
  // Half-sides of boxes: a corner moves by sqrt(2) times as much, less than half-way.
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    if (s.points[i].x() < 60.0) {
      EXPECT_LT(std::numbers::sqrt2 * room[i], 0.5 * apart) << i;
    }
    EXPECT_GT(room[i], 0.0);
  }
}

TEST(SmoothSamples, BothEndsOfASegmentKeepItsRoom) {
  SmoothOptions options;
  options.deviation_m = 2.0;
  const Samples s = sampled(LinePoses({{0, 0}, {16, 0}}), 1.6);
  options.room = [](const Vec2& a, const Vec2&) { return a.x() > 7.0 && a.x() < 9.0 ? 1.0 : 9.0; };
  const std::vector<double> room = rooms(s, options);
  std::size_t narrow = 0;
  for (std::size_t i = 0; i < room.size(); ++i) narrow += room[i] < 1.0 / std::numbers::sqrt2;
  EXPECT_EQ(narrow, 2U);
  options.room = [](const Vec2&, const Vec2&) { return -1.0; };
  for (const double r : rooms(s, options)) EXPECT_EQ(r, 0.0);
}

}  // namespace
}  // namespace swathplan

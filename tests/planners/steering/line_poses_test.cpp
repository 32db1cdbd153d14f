#include "planners/steering/line_poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace swathplan {
namespace {

TEST(LinePoses, DropsPointsThatCoincideAndRemembersWhereTheRestCameFrom) {
  const LinePoses line({{0, 0}, {0, 0}, {3, 0}, {3, 1e-9}, {3, 4}});
  EXPECT_EQ(line.points(), (std::vector<Vec2>{{0, 0}, {3, 0}, {3, 4}}));
  EXPECT_EQ(line.source(), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(line.along(), (std::vector<double>{0.0, 3.0, 7.0}));
  EXPECT_EQ(line.length_m(), 7.0);
  EXPECT_FALSE(line.is_point());
}

TEST(LinePoses, AllPointsAtOnePlaceAreAPoint) {
  const LinePoses line({{2, 5}, {2, 5}});
  EXPECT_TRUE(line.is_point());
  EXPECT_EQ(line.length_m(), 0.0);
  EXPECT_EQ(line.at(0.0).pose.position, Vec2(2, 5));
}

TEST(LinePoses, APlaceOnALongSegmentIsWhereItWasAskedFor) {
  const LinePoses line({{0, 0}, {10, 0}, {10, 10}});
  const auto place = line.at(14.0);
  EXPECT_NEAR((place.pose.position - Vec2(10, 4)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((place.pose.course - Vec2(0, 1)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(place.point.has_value());
  EXPECT_EQ(place.source, 1U);
}

TEST(LinePoses, APlaceOnAShortChordMovesToAPointOfTheCurve) {
  const LinePoses line({{0, 0}, {0.3, 0}, {0.3, 0.3}});
  const auto place = line.at(0.25);
  EXPECT_EQ(place.point, 1U);
  EXPECT_EQ(place.along_m, 0.3);
  // The mean of the courses before and after: north-east.
  EXPECT_NEAR((place.pose.course - Vec2(1, 1).normalized()).norm(), 0.0, 1e-12);
}

// Chords of 2 R sin(t / 2) that meet at the angle t ask for R cos(t / 2).
TEST(LinePoses, AsksForNearlyTheRadiusOfTheCircleThroughItsPoints) {
  constexpr double kCircleM = 5.0;
  const double t = std::numbers::pi / 60.0;
  std::vector<Vec2> points;
  for (int i = 0; i <= 30; ++i) {
    points.emplace_back(kCircleM * std::cos(t * i), kCircleM * std::sin(t * i));
  }
  const LinePoses line(points);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    EXPECT_NEAR(line.radius_at(i, kCircleM), kCircleM * std::cos(0.5 * t), 1e-9);
  }
  EXPECT_EQ(line.radius_at(0, kCircleM), std::numeric_limits<double>::infinity());
  EXPECT_EQ(line.radius_at(30, kCircleM), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace swathplan

#include "mesh/plane/segments.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace swathplan {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Segments, TheNearestPlaceLiesAtTheFootOrAtAnEnd) {
  const Vec2 a(2, 1);
  const Vec2 b(12, 1);
  const SegmentPlace foot = nearest_on_segment(a, b, {4.5, 7});
  EXPECT_EQ(foot.share, 0.25);
  EXPECT_EQ(foot.point, Vec2(4.5, 1));
  EXPECT_EQ(nearest_on_segment(a, b, {-3, 5}).share, 0.0);
  EXPECT_EQ(nearest_on_segment(a, b, {-3, 5}).point, a);
  EXPECT_EQ(nearest_on_segment(a, b, {20, 5}).share, 1.0);
  EXPECT_EQ(nearest_on_segment(a, b, {20, 5}).point, b);
  EXPECT_EQ(distance_to_segment(a, b, {4.5, 7}), 6.0);
  EXPECT_EQ(distance_to_segment(a, b, {15, 5}), 5.0);
}

TEST(Segments, NoPlaceIsNearer) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> at(-100.0, 100.0);
  for (int i = 0; i < 500; ++i) {
    const Vec2 a(at(random), at(random));
    const Vec2 b(at(random), at(random));
    const Vec2 p(at(random), at(random));
    const double least = distance_to_segment(a, b, p);
    for (int k = 0; k <= 40; ++k) {
      EXPECT_LE(least, (a + k / 40.0 * (b - a) - p).norm() + 1e-9) << i;
    }
    EXPECT_NEAR(least, distance_to_segment(b, a, p), 1e-9) << i;
  }
}

TEST(Segments, ASegmentWithoutALengthIsItsFirstEnd) {
  const Vec2 a(3, 4);
  const SegmentPlace place = nearest_on_segment(a, a, {0, 0});
  EXPECT_EQ(place.share, 0.0);
  EXPECT_EQ(place.point, a);
  EXPECT_EQ(distance_to_segment(a, a, {0, 0}), 5.0);
}

TEST(Segments, CrossProductsArePositiveToTheLeft) {
  EXPECT_EQ(cross({2, 0}, {0, 3}), 6.0);
  EXPECT_EQ(cross({0, 3}, {2, 0}), -6.0);
  EXPECT_EQ(cross({1, 2}, {2, 4}), 0.0);
  EXPECT_EQ(cross({0, 0}, {2, 4}), 0.0);
}

TEST(Segments, TurnsToPortArePositive) {
  EXPECT_DOUBLE_EQ(turn_angle({0, 2}, {-3, 0}), 0.5 * kPi);
  EXPECT_DOUBLE_EQ(turn_angle({0, 2}, {3, 0}), -0.5 * kPi);
  EXPECT_DOUBLE_EQ(turn_angle({1, 0}, {5, 5}), 0.25 * kPi);
  EXPECT_EQ(turn_angle({1, 2}, {2, 4}), 0.0);
}

TEST(Segments, TurnsOfDegenerateCourses) {
  for (const Vec2& out : {Vec2(1, 2), Vec2(-1, 2), Vec2(-1, -2), Vec2(0, 0)}) {
    const double turn = std::abs(turn_angle({0, 0}, out));
    EXPECT_TRUE(turn == 0.0 || turn == kPi) << turn;
  }
  EXPECT_DOUBLE_EQ(std::abs(turn_angle({3, 0}, {-1, 0})), kPi);
}

}  // namespace
}  // namespace swathplan

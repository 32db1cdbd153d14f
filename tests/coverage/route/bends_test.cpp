#include "coverage/route/bends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace swathplan {
namespace {

/// At the middle one of three waypoints on a circle.
CourseChange on_circle(double radius_m, double step_deg) {
  const auto at = [&](double deg) {
    const double a = deg * std::numbers::pi / 180.0;
    return Vec2(radius_m * std::cos(a), radius_m * std::sin(a));
  };
  return course_change(at(0.0), at(step_deg), at(2.0 * step_deg));
}

TEST(Bends, OfEvenWaypointsOnACircleHaveItsRadius) {
  for (const double radius : {3.0, 20.0, 400.0}) {
    for (const double step : {1.0, 5.0, 14.0}) {
      // The arc touches the chords, so it is a little flatter inside than the circle through them.
      EXPECT_NEAR(bend_radius_m(on_circle(radius, step), radius) / radius,
                  std::cos(0.5 * step * std::numbers::pi / 180.0), 1e-9);
    }
  }
}

TEST(Bends, TellTheSideOfTheTurn) {
  EXPECT_GT(course_change({0, 0}, {10, 0}, {20, 1}).angle_rad, 0.0) << "to port";
  EXPECT_LT(course_change({0, 0}, {10, 0}, {20, -1}).angle_rad, 0.0) << "to starboard";
  EXPECT_TRUE(std::isinf(bend_radius_m(course_change({0, 0}, {10, 0}, {20, 0}), 5.0)));
}

TEST(Bends, ARightAngleIsACornerAtAnyLengthOfItsLegs) {
  for (const double leg : {5.0, 60.0, 5000.0}) {
    const CourseChange corner = course_change({0, 0}, {leg, 0}, {leg, leg});
    EXPECT_TRUE(is_corner(corner, 3.0)) << leg;
    EXPECT_EQ(bend_radius_m(corner, 3.0), 0.0) << leg;
  }
}

TEST(Bends, AThinnedTightCurveIsNoCorner) {
  // 20 degrees in chords of 1 m: the arc of 3 m passes the waypoint 4.6 cm off.
  EXPECT_FALSE(is_corner(on_circle(3.0, 20.0), 3.0));
  // The same change on a wide curve is drawn 30 cm off.
  EXPECT_TRUE(is_corner(on_circle(20.0, 20.0), 20.0));
}

TEST(Bends, TurnPathsEndInTheMiddleOfTheSegments) {
  const CourseChange change = course_change({0, 0}, {10, 0}, {10, 6});
  EXPECT_NEAR(turn_path_m(change, 2.0), std::numbers::pi, 1e-9);
  EXPECT_DOUBLE_EQ(turn_path_m(change, 100.0), 8.0);
}

}  // namespace
}  // namespace swathplan

#include "planners/steering/even_bends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "planners/steering/basin.h"

namespace swathplan {
namespace {

constexpr double kBendRadius = 1.5;

Area wide_water() { return {{{{-500, -500}, {500, -500}, {500, 500}, {-500, 500}}, {}}}; }

/// Written as a pen moves: straight on, or along an arc in chords.
class Pen {
 public:
  Pen& straight(double metres) {
    at_ += metres * Vec2(std::cos(course_), std::sin(course_));
    points_.push_back(at_);
    return *this;
  }
  /// To port if `turn_deg` is above 0.
  Pen& arc(double radius, double turn_deg, int chords) {
    const double turn = Angle::degrees(turn_deg).rad();
    for (int k = 0; k < chords; ++k) {
      course_ += 0.5 * turn / chords;
      straight(2.0 * radius * std::sin(0.5 * std::abs(turn) / chords));
      course_ += 0.5 * turn / chords;
    }
    return *this;
  }
  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }

 private:
  Vec2 at_ = Vec2::Zero();
  double course_ = 0.0;
  std::vector<Vec2> points_{Vec2::Zero()};
};

Route route_of(const std::vector<Vec2>& points) {
  Route route;
  for (const Vec2& p : points) {
    Waypoint w;
    w.position = p;
    w.line = 1;
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

std::vector<Vec2> points_of(const Route& route) {
  std::vector<Vec2> points;
  for (const Waypoint& w : route.waypoints) points.push_back(w.position);
  return points;
}

double distance_to(const Vec2& p, const std::vector<Vec2>& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 u = line[i + 1] - line[i];
    const double t = std::clamp((p - line[i]).dot(u) / u.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - (line[i] + t * u)).norm());
  }
  return least;
}

void expect_evened(const std::vector<Vec2>& points) {
  ASSERT_LT(tightest(points), kBendRadius);
  const Connector water(wide_water(), {.radius_m = kBendRadius});
  Route route = route_of(points);
  EXPECT_EQ(even_bends(route, kBendRadius, water), 0U);
  const std::vector<Vec2> now = points_of(route);
  EXPECT_GE(tightest(now), kBendRadius * (1.0 - 1e-6));
  EXPECT_EQ(now.front(), points.front());
  EXPECT_EQ(now.back(), points.back());
  for (const Vec2& p : now) EXPECT_LT(distance_to(p, points), 0.002);
  for (const Vec2& p : points) EXPECT_LT(distance_to(p, now), 0.002);
  for (const Waypoint& w : route.waypoints) EXPECT_TRUE(w.feasible);
}

TEST(EvenBends, ChordsOfUnequalLengthThatMeet) {
  expect_evened(Pen().straight(5).arc(1.53, 60, 20).arc(1.53, 42, 18).straight(5).points());
  expect_evened(Pen().straight(5).arc(1.53, 61, 20).arc(1.53, 3, 2).arc(1.6, 90, 30).points());
}

TEST(EvenBends, ASliverBetweenCurves) {
  for (const double sliver : {0.002, 0.013, 0.027, 0.033, 0.038}) {
    expect_evened(Pen()
                      .straight(5)
                      .arc(1.53, 60, 20)
                      .straight(sliver)
                      .arc(1.53, -60, 20)
                      .straight(5)
                      .points());
    expect_evened(Pen()
                      .straight(5)
                      .arc(1.53, 60, 20)
                      .straight(sliver)
                      .arc(1.53, 60, 20)
                      .straight(5)
                      .points());
  }
}

TEST(EvenBends, CurvesThatMeetAtRandom) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 40; ++i) {
    Pen pen;
    pen.straight(3);
    for (int k = 0; k < 6; ++k) {
      const double turn = (share(random) < 0.5 ? -1.0 : 1.0) * (20.0 + 100.0 * share(random));
      const int chords = static_cast<int>(std::ceil(std::abs(turn) / (2.6 + 0.4 * share(random))));
      pen.arc(1.53 + 0.3 * share(random) * share(random), turn, chords);
      if (share(random) < 0.5) pen.straight(0.1 * share(random));
    }
    pen.straight(3);
    if (tightest(pen.points()) < kBendRadius) expect_evened(pen.points());
    if (HasFailure()) FAIL() << "route " << i << " of seed 7";
  }
}

TEST(EvenBends, WhatIsNotTightComesBackAsItIs) {
  const Connector water(wide_water(), {.radius_m = kBendRadius});
  const auto points = Pen().straight(5).arc(1.53, 90, 30).straight(5).points();
  Route route = route_of(points);
  EXPECT_EQ(even_bends(route, kBendRadius, water), 0U);
  EXPECT_EQ(points_of(route), points);
}

TEST(EvenBends, ACornerIsMarkedAndStays) {
  const Connector water(wide_water(), {.radius_m = kBendRadius});
  const std::vector<Vec2> points{{0, 0}, {5, 0}, {5, 1}, {5, 2}, {9, 2}};
  Route route = route_of(points);
  EXPECT_EQ(even_bends(route, kBendRadius, water), 2U);
  EXPECT_EQ(points_of(route), points);
  EXPECT_FALSE(route.waypoints[1].feasible);
  EXPECT_TRUE(route.waypoints[2].feasible);
  EXPECT_FALSE(route.waypoints[3].feasible);
}

}  // namespace
}  // namespace swathplan

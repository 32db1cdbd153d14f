#include "coverage/route/thin_route.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/route/bends.h"
#include "coverage/scenes.h"

namespace swathplan {
namespace {

const FanAngles kThinFan{Angle::degrees(60), Angle::degrees(60)};

/// Two lines of points each 0.1 m, joined by a half circle; slow in the turn's second half.
Route two_lines() {
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(0.0, 0.1 * i);
  for (int i = 0; i < 100; ++i) {
    const double a = 0.01 * 3.14159265358979 * i;
    points.emplace_back(5.0 - 5.0 * std::cos(a), 50.0 + 5.0 * std::sin(a));
  }
  for (int i = 0; i <= 500; ++i) points.emplace_back(10.0, 50.0 - 0.1 * i);
  Route route = testing::route_through(points, kThinFan);
  auto& w = route.waypoints;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (i < 500) w[i].line = 1;
    if (i >= 600) w[i].line = 2;
    if (i < 500 || i >= 600) continue;
    w[i].kind = LegKind::turn;
    w[i].log = false;
    w[i].fan.reset();
    if (i >= 550) w[i].speed_mps = 1.0;
  }
  return route;
}

TEST(ThinRoute, KeepsEndsOfLegsAndChangesOfSpeed) {
  const Route route = two_lines();
  const ThinnedRoute thinned = thin_route(route, 0.1);
  EXPECT_LE(thinned.largest_distance_m, 0.1);
  EXPECT_FALSE(fault(thinned.route).has_value());
  EXPECT_LT(thinned.route.waypoints.size(), 20U);
  const auto& w = thinned.route.waypoints;
  const auto holds = [&](const Waypoint& wanted) {
    return std::any_of(w.begin(), w.end(), [&](const Waypoint& kept) {
      return kept.position == wanted.position && kept.kind == wanted.kind &&
             kept.speed_mps == wanted.speed_mps;
    });
  };
  for (const std::size_t i : {0U, 500U, 550U, 600U, 1100U}) EXPECT_TRUE(holds(route.waypoints[i]));
  const auto all = legs(route);
  const auto kept = legs(thinned.route);
  ASSERT_EQ(all.size(), kept.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(route.waypoints[all[i].first].position, w[kept[i].first].position) << i;
    EXPECT_EQ(route.waypoints[all[i].last].position, w[kept[i].last].position) << i;
  }
}

TEST(ThinRoute, AShortCurveBetweenStraightsBecomesNoCorner) {
  // 20 degrees to port within half a metre: one waypoint would lie 2 cm off the curve.
  const double radius = 1.5;
  const double turn = 20.0 * 3.14159265358979 / 180.0;
  std::vector<Vec2> points{{-60.0, 0.0}, {-30.0, 0.0}};
  for (int i = 0; i <= 10; ++i) {
    const double a = 0.1 * i * turn;
    points.emplace_back(radius * std::sin(a), radius * (1.0 - std::cos(a)));
  }
  for (const double on : {30.0, 60.0}) {
    points.push_back(points[12] + on * Vec2(std::cos(turn), std::sin(turn)));
  }
  const ThinnedRoute thinned = thin_route(testing::route_through(points, kThinFan), 0.1);
  const auto& w = thinned.route.waypoints;
  ASSERT_LT(w.size(), 8U);
  for (std::size_t i = 1; i + 1 < w.size(); ++i) {
    EXPECT_FALSE(
        is_corner(course_change(w[i - 1].position, w[i].position, w[i + 1].position), radius));
  }
}

TEST(ThinRoute, StaysInTheWaterWhereTheRouteDoes) {
  // The water's inner bank follows the turn: every chord of the half circle would cross it.
  const Route route = two_lines();
  std::vector<Vec2> bank;
  for (int i = 0; i <= 200; ++i) {
    const double a = 0.005 * 3.14159265358979 * i;
    bank.emplace_back(5.0 - 4.99 * std::cos(a), 50.0 + 4.99 * std::sin(a));
  }
  const Area sea{{.outer = {{-20, -20}, {30, -20}, {30, 80}, {-20, 80}}, .holes = {}}};
  const AreaQuery query(subtract(sea, from_rings({bank}, true)));
  const auto outside = [&](const Route& r) {
    double sum = 0.0;
    for (std::size_t i = 1; i < r.waypoints.size(); ++i) {
      const Vec2 &a = r.waypoints[i - 1].position, &b = r.waypoints[i].position;
      sum += (b - a).norm() - query.inside_length(a, b);
    }
    return sum;
  };
  ASSERT_LT(outside(route), 0.001);
  EXPECT_GT(outside(thin_route(route, 0.1).route), 1.0);
  const ThinnedRoute thinned = thin_route(route, 0.1, &query);
  EXPECT_LT(outside(thinned.route), 0.05);
  EXPECT_LT(thinned.route.waypoints.size(), 70U);
}

TEST(ThinRoute, ASmallerToleranceKeepsMore) {
  const Route route = two_lines();
  std::size_t before = 0;
  for (const double tolerance : {1.0, 0.1, 0.01, 0.001}) {
    const ThinnedRoute thinned = thin_route(route, tolerance);
    EXPECT_LE(thinned.largest_distance_m, tolerance);
    EXPECT_GT(thinned.route.waypoints.size(), before);
    before = thinned.route.waypoints.size();
    EXPECT_NEAR(length_m(thinned.route), length_m(route), 2.0 * tolerance);
  }
}

}  // namespace
}  // namespace swathplan

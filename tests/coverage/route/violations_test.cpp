#include "coverage/route/violations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coverage/route/route_figures.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

Route through(const std::vector<Vec2>& points) {
  Route route;
  for (const Vec2& p : points) {
    route.waypoints.emplace_back();
    route.waypoints.back().position = p;
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

const Area kWater{{.outer = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, .holes = {}}};

TEST(Violations, NoneOnARouteThatCanBeSailed) {
  EXPECT_TRUE(violations(through({{0, 0}, {10, 0}, {20, 0.5}}), {}, kWater).empty());
}

TEST(Violations, AnInfeasibleLegIsListedWithItsLengthAndMiddle) {
  Route route = through({{0, 0}, {10, 0}, {20, 0}, {40, 0}});
  route.waypoints[1].feasible = route.waypoints[2].feasible = false;
  const auto list = violations(route, {}, kWater);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].kind, ViolationKind::infeasible);
  EXPECT_EQ(list[0].first, 1U);
  EXPECT_EQ(list[0].last, 3U);
  EXPECT_DOUBLE_EQ(list[0].length_m, 30.0);
  EXPECT_NEAR((list[0].position - Vec2(25.0, 0.0)).norm(), 0.0, 1e-9);
}

TEST(Violations, EachStretchOutsideTheWaterIsOne) {
  // Out for 10 m and 10 m beyond the east, back in, then out for 5 m in the west.
  const Route route = through({{0, 0}, {60, 0}, {60, 10}, {-55, 10}});
  std::vector<Violation> out;
  for (const Violation& v : violations(route, {.turn_radius_m = 1e-6}, kWater)) {
    if (v.kind == ViolationKind::outside_water) out.push_back(v);
  }
  ASSERT_EQ(out.size(), 1U);  // the last segment is out at both of its ends
  EXPECT_NEAR(out[0].length_m, 10.0 + 10.0 + 10.0 + 5.0, 1e-3);
  const Route apart = through({{0, 0}, {60, 0}, {60, 10}, {0, 10}, {-40, 10}, {-55, 10}});
  std::size_t stretches = 0;
  for (const Violation& v : violations(apart, {.turn_radius_m = 1e-6}, kWater)) {
    stretches += v.kind == ViolationKind::outside_water ? 1 : 0;
  }
  EXPECT_EQ(stretches, 2U);
}

TEST(Violations, ATightTurnTellsItsRadius) {
  std::vector<Vec2> points{{-20, 0}};
  for (int k = 0; k <= 45; ++k) {
    const double a = std::numbers::pi * k / 45.0;
    points.emplace_back(3.0 * std::sin(a), 3.0 - 3.0 * std::cos(a));
  }
  points.emplace_back(-20, 6);
  EXPECT_TRUE(violations(through(points), {.turn_radius_m = 2.9}, kWater).empty());
  const auto list = violations(through(points), {.turn_radius_m = 5.0}, kWater);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].kind, ViolationKind::tight_turn);
  EXPECT_NEAR(list[0].radius_m, 3.0, 0.01);
  EXPECT_NEAR(list[0].length_m, 3.0 * std::numbers::pi, 0.3);
  EXPECT_NEAR((list[0].position - Vec2(3.0, 3.0)).norm(), 0.0, 0.2);
}

TEST(Violations, AddUpToTheFiguresOfTheRoute) {
  Route route = through({{0, 0}, {60, 0}, {60, 10}, {0, 10}, {0, 12}, {30, 12}, {30, 60}});
  route.waypoints[4].feasible = false;
  const Seafloor seafloor = saddle();
  const Vehicle vehicle{.turn_radius_m = 2.0};
  const RouteFigures figures =
      route_figures(route, vehicle, kWater, DepthQuery(seafloor), 1e4, 25.6);
  double outside = 0.0;
  std::size_t infeasible = 0;
  for (const Violation& v : violations(route, vehicle, kWater)) {
    if (v.kind == ViolationKind::outside_water) outside += v.length_m;
    infeasible += v.kind == ViolationKind::infeasible ? 1 : 0;
  }
  EXPECT_NEAR(outside, figures.outside_water_m, 1e-9);
  EXPECT_EQ(infeasible, figures.infeasible_legs);
}

}  // namespace
}  // namespace swathplan

#include "planners/steering/led_round.h"

#include <gtest/gtest.h>

#include "mesh/plane/area_query.h"
#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::box_area;

/// Lines north and south, 20 m apart, joined straight.
Route lawnmower(int lines, double length_m) {
  Route route;
  for (int i = 0; i < lines; ++i) {
    Waypoint begin;
    begin.line = i;
    begin.position = {20.0 * i, i % 2 == 0 ? 0.0 : length_m};
    Waypoint end;
    end.kind = LegKind::transit;
    end.log = false;
    end.position = {20.0 * i, i % 2 == 0 ? length_m : 0.0};
    route.waypoints.push_back(begin);
    route.waypoints.push_back(end);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

double inside_m(const Route& route, const Area& area) {
  const AreaQuery query(area);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    sum += query.inside_length(route.waypoints[i].position, route.waypoints[i + 1].position);
  }
  return sum;
}

TEST(LedRound, CutsLinesAndLeadsTransitsRound) {
  const Area no_go = box_area(15, 40, 45, 60);
  const LedRound led = led_round(lawnmower(4, 100), no_go, box_area(-20, -20, 90, 120), 1.0);
  EXPECT_FALSE(fault(led.route));
  EXPECT_EQ(inside_m(led.route, no_go), 0.0);
  ASSERT_EQ(led.cut.size(), 2U);
  EXPECT_EQ(led.cut[0].line, 1);
  EXPECT_EQ(led.cut[1].line, 2);
  EXPECT_NEAR(led.cut[0].left_out_m, 22.0, 0.01) << "a metre on either side";
  double surveyed_m = 0.0;
  std::vector<int> order;
  for (std::size_t i = 0; i + 1 < led.route.waypoints.size(); ++i) {
    const Waypoint& w = led.route.waypoints[i];
    if (!is_survey(w.kind)) continue;
    surveyed_m += (led.route.waypoints[i + 1].position - w.position).norm();
    order.push_back(*w.line);
  }
  EXPECT_NEAR(surveyed_m, 400.0 - 44.0, 0.02);
  EXPECT_EQ(order, (std::vector<int>{0, 1, 1, 2, 2, 3}));
}

TEST(LedRound, WhatTheAreaDoesNotTouchStays) {
  const Route route = lawnmower(3, 100);
  const LedRound led = led_round(route, box_area(5, 40, 15, 60), box_area(-9, -9, 60, 120), 1.0);
  EXPECT_TRUE(led.cut.empty());
  EXPECT_EQ(positions(led.route.waypoints), positions(route.waypoints));
}

TEST(LedRound, ATransitInTheAreaGoesRoundAndALineInItIsLeftOut) {
  const Route route = lawnmower(3, 100);
  const Area over_the_transit = box_area(5, 90, 15, 110);
  const LedRound round = led_round(route, over_the_transit, box_area(-20, -20, 90, 130), 1.0);
  EXPECT_TRUE(round.cut.empty());
  EXPECT_EQ(inside_m(round.route, over_the_transit), 0.0);
  EXPECT_GT(round.route.waypoints.size(), route.waypoints.size());
  const LedRound without =
      led_round(route, box_area(15, -5, 25, 105), box_area(-20, -20, 90, 130), 1.0);
  ASSERT_EQ(without.cut.size(), 1U);
  EXPECT_NEAR(without.cut[0].left_out_m, 100.0, 1e-9);
}

TEST(LedRound, WithoutAWayTheTransitIsStraight) {
  // The area closes the water from side to side.
  const Area no_go = box_area(-50, 40, 90, 60);
  const LedRound led = led_round(lawnmower(1, 100), no_go, box_area(-20, -20, 40, 120), 1.0);
  ASSERT_EQ(led.route.waypoints.size(), 4U);
  EXPECT_NEAR(inside_m(led.route, no_go), 20.0, 1e-6);
  EXPECT_TRUE(led_round(lawnmower(1, 30), box_area(-5, -5, 5, 35), box_area(-9, -9, 90, 90), 1.0)
                  .route.waypoints.empty());
}

}  // namespace
}  // namespace swathplan

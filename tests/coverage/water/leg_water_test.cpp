#include "coverage/water/leg_water.h"

#include <gtest/gtest.h>

#include "coverage/scenes.h"

namespace swathplan {
namespace {

/// Ground 3 m deep in the west and 10 m in the east.
Seafloor stepped_ground() {
  Seafloor s;
  testing::add_plate(s, 0, 0, 50, 40, 3.0);
  testing::add_plate(s, 50, 0, 100, 40, 10.0);
  return s;
}

class LegWaterTest : public ::testing::Test {
 protected:
  LegWaterTest() : seafloor(stepped_ground()), depths(seafloor) {
    const FanAngles fan{Angle::degrees(60), Angle::degrees(60)};
    route = testing::route_through({{90, 10}, {60, 10}, {10, 10}}, fan);
    route.waypoints[0].speed_mps = 0.01;  // 3000 s
    route.waypoints[1].speed_mps = 0.01;  // 5000 s
    route.waypoints[1].line = 2;
    vehicle.draft_m = 1.0;
    vehicle.under_keel_margin_m = 0.5;
    vehicle.squat_m = 0.0;
  }
  Seafloor seafloor;
  DepthQuery depths;
  Route route;
  Vehicle vehicle;
};

TEST_F(LegWaterTest, OfStillWaterIsTheDepthLessTheDraft) {
  const auto legs = water_of_legs(route, vehicle, depths, {});
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_NEAR(*legs[0].under_keel_m, 9.0, 1e-9);
  EXPECT_NEAR(*legs[1].under_keel_m, 2.0, 1e-9);
  EXPECT_NEAR(legs[1].start_s, 3000.0, 1e-6);
  EXPECT_NEAR(legs[1].end_s, 8000.0, 1e-6);
  EXPECT_EQ(legs[1].short_of_water, false);
  EXPECT_TRUE(legs[1].windows.empty());
}

TEST_F(LegWaterTest, TheTideOfTheHourCountsAndItsWindows) {
  // From 0 it falls by a metre in 1000 s to -2 m, stays, and rises again.
  const Tide tide({{0.0, 0.0}, {1000.0, -1.0}, {2000.0, -2.0}, {9000.0, -2.0}, {11000.0, 0.0}});
  const auto legs = water_of_legs(route, vehicle, depths, {&tide, 0.0});
  EXPECT_NEAR(*legs[0].under_keel_m, 7.0, 1e-6);
  EXPECT_EQ(legs[0].short_of_water, false);
  EXPECT_NEAR(*legs[1].under_keel_m, 0.0, 1e-6);
  EXPECT_EQ(legs[1].short_of_water, true);
  // 3 m carry the boat (1.5 m) while the tide is above -1.5 m.
  ASSERT_EQ(legs[1].windows.size(), 2U);
  EXPECT_NEAR(legs[1].windows[0].to_s, 1500.0, Tide::kTideStepS);
  EXPECT_NEAR(legs[1].windows[1].from_s, 9500.0, Tide::kTideStepS);
  EXPECT_EQ(legs[0].windows.size(), 1U);
}

// Two sorties: the second one begins half-way on the second leg, a day later.
TEST_F(LegWaterTest, EachSortieHasTheTideOfItsOwnTime) {
  const double day = 86400.0;
  const Tide tide({{0.0, 0.0}, {day - 60.0, 0.0}, {day, -1.0}, {2.0 * day, -1.0}});
  route.waypoints.insert(route.waypoints.begin() + 2, route.waypoints[1]);
  route.waypoints[2].position.x() = 30.0;
  const auto legs = water_of_legs(route, vehicle, depths, {&tide, 0.0, {{0, 0.0}, {2, day}}});
  ASSERT_EQ(legs.size(), 3U) << "parted where the sortie begins";
  EXPECT_NEAR(legs[1].end_s, 6000.0, 1e-6);
  EXPECT_NEAR(*legs[1].under_keel_m, 2.0, 1e-6);
  EXPECT_NEAR(legs[2].start_s, day, 1e-6);
  EXPECT_NEAR(*legs[2].under_keel_m, 1.0, 1e-6);
}

TEST_F(LegWaterTest, TheLeastOfAllLegsAndOfEachLineIsAFigureOfTheRoute) {
  RouteFigures figures;
  add_water(route, water_of_legs(route, vehicle, depths, {}), figures);
  ASSERT_TRUE(figures.least_water);
  EXPECT_EQ(figures.least_water->leg, 2U);
  EXPECT_NEAR(figures.least_water->under_keel_m, 2.0, 1e-9);
  EXPECT_NEAR(figures.least_water->start_s, 3000.0, 1e-6);
  // One line sailed twice has the lesser of both.
  for (Waypoint& w : route.waypoints) {
    if (w.kind == LegKind::end) continue;
    w.kind = LegKind::line;
    w.line = 7;
  }
  figures = {};
  add_water(route, water_of_legs(route, vehicle, depths, {}), figures);
  EXPECT_EQ(figures.under_keel_by_line_m.size(), 1U);
  EXPECT_NEAR(figures.under_keel_by_line_m.at(7), 2.0, 1e-9);
  // Nothing is said of ground without data.
  figures = {};
  for (Waypoint& w : route.waypoints) w.position.x() -= 1e5;
  add_water(route, water_of_legs(route, vehicle, depths, {}), figures);
  EXPECT_FALSE(figures.least_water);
}

TEST_F(LegWaterTest, BeyondTheTableOrTheDataNothingIsSaid) {
  const Tide tide({{0.0, 0.0}, {3600.0, 0.0}});
  const auto legs = water_of_legs(route, vehicle, depths, {&tide, 0.0});
  EXPECT_TRUE(legs[0].under_keel_m);
  EXPECT_FALSE(legs[1].under_keel_m) << "sailed after the table's end";
  EXPECT_EQ(legs[1].windows.size(), 1U);
  route.waypoints[2].position = Vec2(-20, 10);
  EXPECT_FALSE(water_of_legs(route, vehicle, depths, {})[1].least_depth_m);
}

}  // namespace
}  // namespace swathplan

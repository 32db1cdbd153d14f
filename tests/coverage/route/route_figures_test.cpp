#include "coverage/route/route_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coverage/route/over_land.h"
#include "coverage/route/violations.h"
#include "coverage/scenes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::rectangle;
using testing::route_through;

const FanAngles kLegFan{Angle::degrees(60), Angle::degrees(60)};

struct Flat {
  Seafloor seafloor = flat(100, 100, 10);
  DepthQuery depths{seafloor};
};

RouteFigures figures(const Route& route, const Area& water = rectangle(0, 0, 100, 100)) {
  const Flat f;
  return route_figures(route, {}, water, f.depths, 1000.0, 10.0);
}

std::vector<Vec2> arc(const Vec2& centre, double radius, double from_deg, double to_deg, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) {
    const double a = Angle::degrees(from_deg + (to_deg - from_deg) * i / n).rad();
    points.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return points;
}

TEST(RouteFigures, LengthTimeAndKinds) {
  Route route = route_through({{10, 10}, {40, 10}, {40, 50}, {10, 50}}, kLegFan);
  route.waypoints[1].kind = LegKind::transit;
  route.waypoints[1].log = false;
  route.waypoints[1].speed_mps = 4.0;
  const RouteFigures f = figures(route);
  EXPECT_DOUBLE_EQ(f.length_m, 100.0);
  EXPECT_DOUBLE_EQ(f.length_by_kind_m.at("line"), 60.0);
  EXPECT_DOUBLE_EQ(f.length_by_kind_m.at("transit"), 40.0);
  EXPECT_DOUBLE_EQ(f.logged_length_m, 60.0);
  EXPECT_DOUBLE_EQ(f.length_ratio, 1.0);
  EXPECT_DOUBLE_EQ(f.duration_s, 15.0 + 10.0 + 15.0);
  EXPECT_EQ(f.turns, 2U);
  EXPECT_EQ(f.sharp_turns, 2U);
  EXPECT_NEAR(f.total_turning_deg, 180.0, 1e-9);
  EXPECT_NEAR(f.min_under_keel_m, 9.7, 1e-9);
  EXPECT_EQ(f.outside_water_m, 0.0);
}

TEST(RouteFigures, ContingencyCountsAgainstTheEndurance) {
  const Route route = route_through({{10, 10}, {90, 10}}, kLegFan);
  const Flat f;
  Vehicle vehicle;
  const auto of = [&](double contingency, double endurance_s) {
    vehicle.contingency = contingency;
    vehicle.endurance_h = endurance_s / 3600.0;
    return route_figures(route, vehicle, rectangle(0, 0, 100, 100), f.depths, 1000.0, 10.0);
  };
  const double seconds = of(0.0, 1000.0).duration_s;
  EXPECT_EQ(of(0.0, 1000.0).contingency_s, 0.0);
  EXPECT_DOUBLE_EQ(of(0.25, 1000.0).contingency_s, 0.25 * seconds);
  EXPECT_EQ(of(0.25, 1000.0).duration_s, seconds);
  EXPECT_FALSE(of(0.0, 1.2 * seconds).beyond_endurance);
  EXPECT_EQ(endurance_note(of(0.0, 1.2 * seconds), vehicle), "");
  EXPECT_TRUE(of(0.25, 1.2 * seconds).beyond_endurance);
  const std::string note = endurance_note(of(0.25, 1.2 * seconds), vehicle);
  EXPECT_NE(note.find("25 %"), std::string::npos) << note;
  EXPECT_NE(note.find("endurance"), std::string::npos) << note;
}

TEST(RouteFigures, ACurveOfManyBendsCountsOnceAndHasItsRadius) {
  const RouteFigures f = figures(route_through(arc({50, 50}, 20, 0, 90, 60), kLegFan));
  EXPECT_EQ(f.turns, 1U);
  EXPECT_NEAR(f.total_turning_deg, 88.5, 1e-6);
  EXPECT_NEAR(f.min_turn_radius_m, 20.0, 0.01);
  EXPECT_EQ(f.sharp_turns, 0U);
  EXPECT_EQ(figures(route_through(arc({50, 50}, 20, 0, 180, 90), kLegFan)).sharp_turns, 1U);
}

TEST(RouteFigures, BendsToEitherSideAreDifferentCurves) {
  auto points = arc({30, 50}, 10, 180, 0, 60);
  const auto back = arc({50, 50}, 10, 180, 360, 60);
  points.insert(points.end(), back.begin() + 1, back.end());
  EXPECT_EQ(figures(route_through(points, kLegFan)).turns, 2U);
}

/// Port, starboard and port again, as a boat turns onto a line that lies nearer than its turn.
std::vector<Vec2> swung_turn(int bends) {
  auto points = arc({70, 40}, 10, 90, 0, bends);
  points.insert(points.begin(), {20, 50});
  for (const Vec2& p : arc({90, 40}, 10, 180, 450, 3 * bends)) points.push_back(p);
  return points;
}

TEST(RouteFigures, ATurnBetweenLinesIsOneManoeuvreHoweverItSwings) {
  for (const int bends : {12, 60}) {
    Route route = route_through(swung_turn(bends), kLegFan);
    EXPECT_EQ(figures(route).turns, 2U) << bends;
    for (std::size_t i = 1; i + 1 < route.waypoints.size(); ++i) {
      route.waypoints[i].kind = LegKind::turn;
    }
    EXPECT_EQ(figures(route).turns, 1U) << bends;
  }
}

TEST(RouteFigures, ACurveCountsOnceHoweverFewItsWaypoints) {
  Vehicle ship;
  ship.turn_radius_m = 20.0;
  const Flat f;
  for (const int bends : {5, 20, 90}) {
    const RouteFigures curve =
        route_figures(route_through(arc({50, 50}, 20, 0, 180, bends), kLegFan), ship,
                      rectangle(0, 0, 100, 100), f.depths, 1000.0, 10.0);
    EXPECT_EQ(curve.turns, 1U) << bends;
  }
}

TEST(RouteFigures, AStraightRouteHasNoTurnAndNoRadius) {
  const RouteFigures f =
      figures(route_through({{10, 10}, {20, 20}, {20, 20}, {35, 35}, {70, 70}}, kLegFan));
  EXPECT_EQ(f.turns, 0U);
  EXPECT_TRUE(f.min_turn_radius_m > 1e6);
}

TEST(RouteFigures, ACornerIsNoCurveHoweverLongItsLegs) {
  const auto corner = [](double leg_m, double turn_deg) {
    const double a = turn_deg * std::numbers::pi / 180.0;
    return figures(route_through(
        {{50 - leg_m, 50}, {50, 50}, {50 + leg_m * std::cos(a), 50 + leg_m * std::sin(a)}},
        kLegFan));
  };
  for (const double leg_m : {0.5, 5.0, 45.0}) {
    SCOPED_TRACE(leg_m);
    const RouteFigures f = corner(leg_m, 90.0);
    EXPECT_EQ(f.sharp_corners, 1U);
    EXPECT_EQ(f.min_turn_radius_m, 0.0);
    EXPECT_GT(f.tight_turn_m, 0.0);
    EXPECT_EQ(corner(leg_m, 180.0).sharp_corners, 1U);
  }
  EXPECT_EQ(corner(45.0, 16.0).sharp_corners, 1U);
  const RouteFigures gentle = corner(45.0, 10.0);
  EXPECT_EQ(gentle.sharp_corners, 0U);
  EXPECT_NEAR(gentle.min_turn_radius_m, 22.5 / std::tan(std::numbers::pi / 36.0), 1e-6);
  EXPECT_EQ(gentle.tight_turn_m, 0.0);
}

TEST(RouteFigures, ACurveThatWasThinnedByDecimetresHasNoCorners) {
  for (const double radius_m : {1.5, 5.0, 20.0}) {
    SCOPED_TRACE(radius_m);
    // Chords that leave the circle by a decimetre.
    const double step = 2.0 * std::acos(1.0 - 0.1 / radius_m);
    const auto chords = static_cast<int>(std::ceil(std::numbers::pi / step));
    Vehicle vehicle;
    vehicle.turn_radius_m = radius_m;
    const Flat f;
    const RouteFigures thinned =
        route_figures(route_through(arc({50, 50}, radius_m, 0, 180, chords), kLegFan), vehicle,
                      rectangle(0, 0, 100, 100), f.depths, 1000.0, 10.0);
    EXPECT_EQ(thinned.sharp_corners, 0U);
    // The same path asks too much of a boat that turns twice as wide.
    vehicle.turn_radius_m = 4.0 * radius_m;
    EXPECT_GT(route_figures(route_through(arc({50, 50}, radius_m, 0, 180, chords), kLegFan),
                            vehicle, rectangle(0, 0, 100, 100), f.depths, 1000.0, 10.0)
                  .tight_turn_m,
              0.0);
  }
}

TEST(RouteFigures, CornersAreSaidInOneSentence) {
  const RouteFigures f = figures(route_through({{10, 10}, {60, 10}, {60, 60}}, kLegFan));
  const std::string note = corners_note(f, {});
  EXPECT_EQ(note.find("1 corner that cannot be sailed as drawn"), 0U) << note;
  EXPECT_EQ(corners_note(figures(route_through({{10, 10}, {60, 10}}, kLegFan)), {}), "");
}

TEST(RouteFigures, MetresOutsideTheWaterAreMeasured) {
  Area water = rectangle(20, 0, 80, 100);
  water[0].holes.push_back({{45, 45}, {45, 55}, {55, 55}, {55, 45}});
  const RouteFigures f = figures(route_through({{10, 50}, {90, 50}}, kLegFan), water);
  EXPECT_NEAR(f.outside_water_m, 30.0, 1e-6);
  EXPECT_EQ(figures(route_through({{20, 0}, {20, 100}, {80, 100}}, kLegFan), water).outside_water_m,
            0.0);
}

TEST(RouteFigures, LeastWaterUnderTheKeelIsFoundBetweenWaypoints) {
  Seafloor s = flat(100, 100, 10);
  // A rock of 4 m at the node nearest (50, 50).
  for (Vec3& v : s.vertices) {
    if ((v.head<2>() - Vec2(50, 50)).norm() < 0.1) v.z() = -4;
  }
  const DepthQuery depths(s);
  const RouteFigures f = route_figures(route_through({{0, 50}, {100, 50}}, kLegFan), {},
                                       rectangle(0, 0, 100, 100), depths, 1, 1);
  EXPECT_NEAR(f.min_under_keel_m, 3.7, 1e-9);
  const RouteFigures nowhere = route_figures(route_through({{-9, -9}, {-5, -9}}, kLegFan), {},
                                             rectangle(0, 0, 100, 100), depths, 1, 1);
  EXPECT_TRUE(std::isinf(nowhere.min_under_keel_m));
  EXPECT_NEAR(nowhere.over_unknown_m, 4.0, 1e-9);
}

TEST(RouteFigures, ALegOfAMillionKilometresIsLookedAtWhereDataAre) {
  const Seafloor s = flat(100, 100, 10);
  const DepthQuery depths(s);
  const RouteFigures f = route_figures(route_through({{50, 50}, {1e9, 50}}, kLegFan), {},
                                       rectangle(0, 0, 100, 100), depths, 1, 1);
  EXPECT_NEAR(f.over_unknown_m, 1e9 - 100.0, 3.0);
}

// Known water at both ends says nothing of the land between.
TEST(RouteFigures, APathOverLandHasNoLeastWaterUnderTheKeel) {
  Seafloor s = flat(100, 100, 10);
  std::erase_if(s.faces, [&](const auto& f) { return std::abs(s.vertices[f[0]].x() - 50) < 10; });
  const DepthQuery depths(s);
  const Area water = unite(rectangle(0, 0, 38, 100), rectangle(62, 0, 100, 100));
  const auto over = [&](const Area& where) {
    return route_figures(route_through({{20, 50}, {80, 50}}, kLegFan), {}, where, depths, 1, 1);
  };
  EXPECT_TRUE(std::isinf(over(water).min_under_keel_m));
  EXPECT_NEAR(over(water).over_unknown_m, 20.0, 3.0);
  // Where the boat may run out beyond the data, that is no finding.
  EXPECT_NEAR(over(rectangle(0, 0, 100, 100)).min_under_keel_m, 9.7, 1e-9);
  EXPECT_EQ(over(rectangle(0, 0, 100, 100)).over_unknown_m, 0.0);
  // Of 24 m outside the water, known land takes a half of the 20 m without data.
  const RouteFigures told = route_figures(route_through({{20, 50}, {80, 50}}, kLegFan), {}, water,
                                          depths, 1, 1, rectangle(45, 0, 55, 100));
  EXPECT_NEAR(told.over_land_m, 10.0, 1e-6);
  EXPECT_NEAR(told.over_unknown_m, 10.0, 3.0);
  EXPECT_TRUE(std::isinf(told.min_under_keel_m));
}

TEST(OverLand, AWholeLegOverLandIsMarkedAndItsNeighboursAreNot) {
  Route route = route_through({{0, 0}, {10, 0}, {20, 0}, {30, 0}, {40, 0}}, kLegFan);
  route.waypoints[0].kind = LegKind::transit;
  route.waypoints[3].kind = LegKind::turn;
  EXPECT_EQ(mark_over_land(route, {}), 0U);
  // A shore that is only touched is none.
  EXPECT_EQ(mark_over_land(route, rectangle(-1, -1, 0.005, 1)), 0U);
  const Area land = rectangle(12, -1, 14, 1);
  EXPECT_EQ(mark_over_land(route, land), 1U);
  EXPECT_EQ(mark_over_land(route, land), 0U);
  std::vector<bool> feasible;
  for (const Waypoint& w : route.waypoints) feasible.push_back(w.feasible);
  EXPECT_EQ(feasible, (std::vector<bool>{true, false, false, true, true}));
  const auto list = violations(route, {}, rectangle(-9, -9, 99, 9), land);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(reason(list[0], route, {}), "leads over land or through a no-go area for 2.0 m");
}

TEST(RouteFigures, BendsOfRoundingLeaveARouteStraight) {
  const RouteFigures f = figures(route_through({{0, 0}, {40, 1e-13}, {80, 0}}, kLegFan));
  EXPECT_TRUE(std::isinf(f.min_turn_radius_m));
}

TEST(RouteFigures, CrossingsOfTheRouteWithItself) {
  EXPECT_EQ(
      figures(route_through({{10, 10}, {30, 30}, {30, 10}, {10, 30}}, kLegFan)).self_crossings, 1U);
}

}  // namespace
}  // namespace swathplan

#include "coverage/route/route.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace swathplan {
namespace {

using ::testing::HasSubstr;

/// Five waypoints along two sides of a rectangle: 10 m east, 20 m north, with a valid end.
Route valid_route() {
  Route route;
  for (const Vec2& p : {Vec2(0, 0), Vec2(4, 0), Vec2(10, 0), Vec2(10, 5), Vec2(10, 20)}) {
    Waypoint w;
    w.position = p;
    w.fan = FanAngles{Angle::degrees(50), Angle::degrees(50)};
    w.line = 1;
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

TEST(Route, NamesOfLegsAreReadBack) {
  for (const LegKind kind : {LegKind::line, LegKind::turn, LegKind::transit, LegKind::cross,
                             LegKind::infill, LegKind::run_in, LegKind::run_out, LegKind::end}) {
    EXPECT_EQ(leg_kind(name(kind)), kind) << name(kind);
  }
  EXPECT_FALSE(leg_kind("Line").has_value());
  EXPECT_FALSE(leg_kind("").has_value());
}

TEST(Route, LengthIsTheSumOfItsSegments) {
  EXPECT_DOUBLE_EQ(length_m(valid_route()), 30.0);
  EXPECT_EQ(length_m({}), 0.0);
}

TEST(Route, PositionsKeepTheirOrder) {
  const std::vector<Vec2> points = positions(valid_route().waypoints);
  ASSERT_EQ(points.size(), 5U);
  EXPECT_EQ(points[1], Vec2(4, 0));
  EXPECT_EQ(points[4], Vec2(10, 20));
}

TEST(Route, ARouteOfOneKindIsOneLeg) {
  const auto found = legs(valid_route());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, 0U);
  EXPECT_EQ(found[0].last, 4U);
  EXPECT_TRUE(legs({}).empty());
}

TEST(Route, AnyChangeOfWhatHoldsBeginsALegAtTheSharedWaypoint) {
  const std::vector<void (*)(Waypoint&)> changes{[](Waypoint& w) { w.kind = LegKind::turn; },
                                                 [](Waypoint& w) { w.log = false; },
                                                 [](Waypoint& w) { w.line = 2; },
                                                 [](Waypoint& w) { w.region = 0; },
                                                 [](Waypoint& w) { w.feasible = false; },
                                                 [](Waypoint& w) { w.fan.reset(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Route route = valid_route();
    changes[i](route.waypoints[2]);
    changes[i](route.waypoints[3]);
    const auto found = legs(route);
    ASSERT_EQ(found.size(), 2U) << i;
    EXPECT_EQ(found[0].last, 2U) << i;
    EXPECT_EQ(found[1].first, 2U) << i;
    EXPECT_EQ(found[1].last, 4U) << i;
  }
}

TEST(Route, OtherAnglesOrSpeedsMakeNoLeg) {
  Route route = valid_route();
  route.waypoints[2].fan->port = Angle::degrees(30);
  route.waypoints[2].speed_mps = 1.0;
  EXPECT_EQ(legs(route).size(), 1U);
}

TEST(Route, FaultsNameTheWaypoint) {
  EXPECT_FALSE(fault(valid_route()).has_value());
  const auto broken = [](auto change) {
    Route route = valid_route();
    change(route.waypoints);
    return fault(route).value_or("no fault");
  };
  EXPECT_THAT(broken([](auto& w) { w.resize(1); }), HasSubstr("has 1"));
  EXPECT_THAT(broken([](auto& w) { w[2].position.x() = std::nan(""); }),
              HasSubstr("waypoint 2 has no finite position"));
  EXPECT_THAT(broken([](auto& w) { w[1].kind = LegKind::end; }), HasSubstr("waypoint 1"));
  EXPECT_THAT(broken([](auto& w) { w[4].kind = LegKind::line; }), HasSubstr("waypoint 4"));
  EXPECT_THAT(broken([](auto& w) { w[3].fan->port = Angle::degrees(90); }),
              HasSubstr("waypoint 3: half-angles"));
  EXPECT_THAT(broken([](auto& w) { w[3].fan->starboard = Angle::degrees(0); }),
              HasSubstr("waypoint 3: half-angles"));
  EXPECT_THAT(broken([](auto& w) { w[0].speed_mps = 0.0; }), HasSubstr("waypoint 0: speed"));
  EXPECT_THAT(broken([](auto& w) { w[0].speed_mps = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("waypoint 0: speed"));
}

}  // namespace
}  // namespace swathplan

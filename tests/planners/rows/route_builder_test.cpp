#include "planners/rows/route_builder.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

/// Open water of 400 x 400 m and lines that run north at the given eastings.
struct BuilderBench {
  BuilderBench() : connector(connector_for(site.ground, how)) {}

  [[nodiscard]] std::vector<Waypoint> northward(double x, int number) const {
    return line_waypoints({{x, 100}, {x, 300}}, number, fan, how);
  }

  TestSite site{flat(400, 400, 20)};
  PlanOptions how = row_options(0.10, 1);
  FanAngles fan{Angle::degrees(50), Angle::degrees(50)};
  Connector connector;
};

TEST(RouteBuilder, ALineHasItsTwoEndsNumberFanAndSpeed) {
  const BuilderBench bench;
  const auto line = bench.northward(50, 3);
  ASSERT_EQ(line.size(), 2U);
  EXPECT_EQ(line[0].position, Vec2(50, 100));
  EXPECT_EQ(line[1].position, Vec2(50, 300));
  for (const Waypoint& w : line) {
    EXPECT_EQ(w.kind, LegKind::line);
    EXPECT_EQ(w.line, 3);
    EXPECT_EQ(w.fan, bench.fan);
    EXPECT_EQ(w.speed_mps, bench.how.vehicle.speed_mps);
  }
}

TEST(RouteBuilder, NearLinesAreJoinedByATurnFarOnesByATransit) {
  BuilderBench bench;
  EXPECT_NEAR(turn_reach_m(bench.how), 2.0 * footprint_width_m(bench.how.sonar, 0.10), 1e-9);
  const auto kind_of_join = [&](double gap) {
    RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
    builder.add_line(bench.northward(100, 0));
    auto back = bench.northward(100 + gap, 1);
    std::swap(back[0].position, back[1].position);
    builder.add_line(back);
    const Route route = builder.finish();
    EXPECT_FALSE(fault(route)) << *fault(route);
    EXPECT_TRUE(builder.notes().empty());
    const auto parts = legs(route);
    EXPECT_EQ(parts.size(), 3U);
    const Waypoint& join = route.waypoints[parts[1].first];
    EXPECT_FALSE(join.log);
    EXPECT_FALSE(join.line);
    EXPECT_TRUE(join.feasible);
    EXPECT_EQ(join.fan, bench.fan);
    return join.kind;
  };
  EXPECT_EQ(kind_of_join(0.8 * turn_reach_m(bench.how)), LegKind::turn);
  EXPECT_EQ(kind_of_join(1.2 * turn_reach_m(bench.how)), LegKind::transit);
}

TEST(RouteBuilder, WhereLoggedLegsCountAJoinSpeedsUpOnItsStraightStretch) {
  BuilderBench bench;
  bench.how.counted = Counted::logged;
  bench.how.vehicle.transit_speed_mps = 2.0 * bench.how.vehicle.turn_speed_mps;
  const double radius = bench.how.vehicle.turn_radius_m;
  const auto joined = [&](double gap) {
    RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
    builder.add_line(bench.northward(100, 0));
    auto back = bench.northward(100 + gap, 1);
    std::swap(back[0].position, back[1].position);
    builder.add_line(back);
    return builder.finish();
  };
  const Route far = joined(2.0 * radius + 1.5 * kStraightRadii * radius);
  std::vector<LegKind> kinds;
  for (const Leg& leg : legs(far)) kinds.push_back(far.waypoints[leg.first].kind);
  EXPECT_EQ(kinds, (std::vector<LegKind>{LegKind::line, LegKind::turn, LegKind::transit,
                                         LegKind::turn, LegKind::line}));
  for (std::size_t i = 0; i + 1 < far.waypoints.size(); ++i) {
    const Waypoint& w = far.waypoints[i];
    const bool straight = w.kind == LegKind::transit;
    if (w.kind == LegKind::line) continue;
    EXPECT_EQ(w.speed_mps,
              straight ? bench.how.vehicle.transit_speed_mps : bench.how.vehicle.turn_speed_mps);
    if (straight) {
      const Vec2 course = (far.waypoints[i + 1].position - w.position).normalized();
      EXPECT_NEAR(course.x(), 1.0, 1e-3);
    }
  }
  const Route near = joined(2.0 * radius + 0.75 * kStraightRadii * radius);
  std::set<double> speeds;
  for (const Waypoint& w : near.waypoints) {
    EXPECT_NE(w.kind, LegKind::transit);
    if (w.kind == LegKind::turn) speeds.insert(w.speed_mps);
  }
  EXPECT_EQ(speeds,
            (std::set<double>{bench.how.vehicle.turn_speed_mps, bench.how.vehicle.speed_mps}));
  speeds.clear();
  for (const Waypoint& w : joined(2.0 * radius + 0.3 * kStraightRadii * radius).waypoints) {
    if (w.kind == LegKind::turn) speeds.insert(w.speed_mps);
  }
  EXPECT_EQ(speeds, std::set<double>{bench.how.vehicle.turn_speed_mps});
}

TEST(RouteBuilder, RunsInAndOutLieStraightBeforeAndBehindTheLine) {
  BuilderBench bench;
  bench.how.run_in_m = 30.0;
  bench.how.run_out_m = 20.0;
  RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
  builder.add_line(bench.northward(100, 0));
  ASSERT_TRUE(builder.at());
  EXPECT_NEAR((*builder.at() - Vec2(100, 320)).norm(), 0.0, 1e-9);
  const Route route = builder.finish();
  EXPECT_NEAR(length_m(route), 250.0, 1e-6);
  EXPECT_NEAR((route.waypoints.front().position - Vec2(100, 70)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((route.waypoints.back().position - Vec2(100, 320)).norm(), 0.0, 1e-9);
  EXPECT_EQ(route.waypoints.front().kind, LegKind::run_in);
  EXPECT_FALSE(route.waypoints.front().log);
}

TEST(RouteBuilder, ARunOutEndsWhereTheWaterDoesAndSaysSo) {
  BuilderBench bench;
  bench.how.run_out_m = 200.0;
  RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
  builder.add_line(bench.northward(100, 0));
  const BuiltRoute built = builder.built();
  EXPECT_LE(built.route.waypoints.back().position.y(), 400.0);
  ASSERT_EQ(built.notes.size(), 1U);
  EXPECT_NE(built.notes[0].find("shorter than asked for"), std::string::npos);
}

TEST(RouteBuilder, WithoutALineThereIsNoPlace) {
  BuilderBench bench;
  RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
  EXPECT_FALSE(builder.at());
  builder.add_line({});
  EXPECT_TRUE(builder.finish().waypoints.empty());
}

TEST(RouteBuilder, RejoiningAsBeforeKeepsTheRoute) {
  BuilderBench bench;
  RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
  builder.add_line(bench.northward(100, 0));
  auto back = bench.northward(120, 1);
  std::swap(back[0].position, back[1].position);
  builder.add_line(back);
  const Route route = builder.finish();
  const Route again = rejoined(route, bench.site.ground, bench.how, bench.connector).route;
  EXPECT_NEAR(length_m(again), length_m(route), 1e-6);
  EXPECT_EQ(legs(again).size(), legs(route).size());
}

}  // namespace
}  // namespace swathplan

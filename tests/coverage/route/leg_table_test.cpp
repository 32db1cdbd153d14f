#include "coverage/route/leg_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/route/thin_route.h"
#include "coverage/scenes.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// Two lines with fans and speeds of their own, a waypoint each half metre, joined by a turn.
Route two_settings() {
  Route route;
  const auto add = [&](const Vec2& p, LegKind kind, double half_deg, double speed_mps) {
    Waypoint w;
    w.position = p;
    w.kind = kind;
    w.log = kind == LegKind::line;
    if (w.log) w.line = half_deg > 50 ? 1 : 2;
    w.fan = FanAngles{Angle::degrees(half_deg), Angle::degrees(half_deg - 10.0)};
    w.speed_mps = speed_mps;
    route.waypoints.push_back(w);
  };
  for (int i = 0; i < 40; ++i) add({0.0, 0.5 * i}, LegKind::line, 60.0, 2.0);
  for (int i = 0; i < 20; ++i) add({0.5 * i, 20.0}, LegKind::turn, 60.0, 1.0);
  for (int i = 0; i <= 40; ++i) add({10.0, 20.0 - 0.5 * i}, LegKind::line, 45.0, 1.5);
  route.waypoints.back().kind = LegKind::end;
  route.waypoints.back().log = false;
  return route;
}

/// What a format without angles, kinds and speeds leaves, to a centimetre.
Route bare(const Route& route) {
  Route result = thin_route(route, 0.1).route;
  for (Waypoint& w : result.waypoints) {
    Waypoint plain;
    plain.position = (100.0 * w.position).array().round() / 100.0;
    plain.kind = w.kind == LegKind::end ? LegKind::end : LegKind::line;
    w = plain;
  }
  return result;
}

TEST(LegTable, HoldsARowWhereSomethingChanges) {
  const Route table = leg_table(two_settings());
  ASSERT_EQ(table.waypoints.size(), 4U);
  EXPECT_EQ(table.waypoints[1].kind, LegKind::turn);
  EXPECT_EQ(table.waypoints[2].speed_mps, 1.5);
  EXPECT_EQ(table.waypoints[3].kind, LegKind::end);
  EXPECT_TRUE(leg_table({}).waypoints.empty());
}

// A boat that takes the next line from the end of this one turns by a loop.
TEST(LegTable, ALoopIsNoPartOfTheLineBehindIt) {
  Route route;
  const auto add = [&](const Vec2& p, LegKind kind, int line) {
    Waypoint w;
    w.position = p;
    w.kind = kind;
    w.log = kind == LegKind::line;
    if (w.log) w.line = line;
    w.fan = FanAngles{Angle::degrees(60), Angle::degrees(60)};
    w.speed_mps = w.log ? 2.0 : 1.0;
    route.waypoints.push_back(w);
  };
  for (int i = 0; i < 40; ++i) add({0.0, 0.5 * i}, LegKind::line, 1);
  for (int i = 0; i < 60; ++i) {
    const double a = 3.14159265358979 * i / 30.0;
    add({5.0 - 5.0 * std::cos(a), 20.0 + 5.0 * std::sin(a)}, LegKind::turn, 0);
  }
  for (int i = 0; i <= 40; ++i) add({0.0, 20.0 + 0.5 * i}, LegKind::line, 2);
  route.waypoints.back().kind = LegKind::end;
  route.waypoints.back().log = false;
  const Route back = with_leg_table(bare(route), leg_table(route));
  double logged = 0.0;
  for (std::size_t i = 0; i + 1 < back.waypoints.size(); ++i) {
    const Waypoint& w = back.waypoints[i];
    if (w.log) logged += (back.waypoints[i + 1].position - w.position).norm();
  }
  EXPECT_NEAR(logged, 40.0, 0.1);
  // A format of lines alone leaves the loop out.
  Route lines = route;
  std::erase_if(lines.waypoints, [](const Waypoint& w) { return w.kind == LegKind::turn; });
  EXPECT_NO_THROW((void)with_leg_table(lines, leg_table(route)));
  EXPECT_EQ(with_leg_table(lines, leg_table(route)).waypoints[40].line, 2);
}

TEST(LegTable, GivesAnExportBackWhatItsFormatLost) {
  const Route route = two_settings();
  const Route thin = thin_route(route, 0.1).route;
  const Route back = with_leg_table(bare(route), leg_table(route));
  ASSERT_EQ(back.waypoints.size(), thin.waypoints.size());
  for (std::size_t i = 0; i < thin.waypoints.size(); ++i) {
    EXPECT_EQ(back.waypoints[i].log, thin.waypoints[i].log) << i;
    if (i + 1 == thin.waypoints.size()) continue;
    EXPECT_EQ(back.waypoints[i].kind, thin.waypoints[i].kind) << i;
    EXPECT_EQ(back.waypoints[i].line, thin.waypoints[i].line) << i;
    EXPECT_EQ(back.waypoints[i].fan, thin.waypoints[i].fan) << i;
    EXPECT_EQ(back.waypoints[i].speed_mps, thin.waypoints[i].speed_mps) << i;
  }
  EXPECT_EQ(fault(back), std::nullopt);
}

TEST(LegTable, OfAnotherRouteIsRefused) {
  Route other = two_settings();
  for (Waypoint& w : other.waypoints) w.position.x() += 1.0;
  EXPECT_THROW((void)with_leg_table(bare(two_settings()), leg_table(other)), InvalidInput);
}

TEST(LegTable, LeavesOutWhatAFormatHasNoTurnsFor) {
  // Planned lines alone, as LNW has them: the turn is a straight from end to start.
  const Route route = two_settings();
  Route lines = bare(route);
  std::erase_if(lines.waypoints,
                [](const Waypoint& w) { return w.position.x() > 0.2 && w.position.x() < 9.8; });
  const Route back = with_leg_table(lines, leg_table(route));
  double logged = 0.0;
  for (std::size_t i = 0; i + 1 < back.waypoints.size(); ++i) {
    if (!back.waypoints[i].log) continue;
    logged += (back.waypoints[i + 1].position - back.waypoints[i].position).norm();
  }
  EXPECT_NEAR(logged, 40.0, 0.1);
}

}  // namespace
}  // namespace swathplan

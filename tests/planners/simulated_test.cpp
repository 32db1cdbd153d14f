#include "planners/simulated.h"

#include <gtest/gtest.h>

#include "coverage/score.h"
#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

/// One line north through a flat floor of 40 x 40 m, logged.
Route one_line(double x, double half_angle_deg) {
  Route route;
  for (const double y : {1.0, 39.0}) {
    Waypoint w;
    w.position = {x, y};
    w.line = 0;
    w.fan = FanAngles{Angle::degrees(half_angle_deg), Angle::degrees(half_angle_deg)};
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

TEST(SimulatedHits, AgreeWithTheScoreOfTheSameRoute) {
  TestSite site(flat(40, 40, 10));
  const RayScene scene(site.seafloor, Nodata::open);
  site.ground.scene = &scene;
  const PlanOptions how = row_options(0.5, 1);
  const Route route = one_line(20, 45);
  const Outcome outcome = simulated_hits(route, site.ground, how);
  ScoreOptions scoring;
  scoring.resolution_m = 0.5;
  const Score judged = score(route, site.ground, how.sonar, how.vehicle, scoring).score;
  EXPECT_EQ(outcome.cover_pct, judged.all.hit_pct);
  EXPECT_EQ(outcome.length_ratio, judged.route.length_ratio);
  EXPECT_EQ(outcome.duration_s, judged.route.duration_s);
  EXPECT_DOUBLE_EQ(outcome.length_m, 38.0);
  EXPECT_EQ(outcome.infeasible_legs, 0U);
  EXPECT_EQ(outcome.cover, Cover::hit);
  EXPECT_TRUE(outcome.what.empty());
  // A swath of 20 m over 38 of 40 m: just under half of the cells.
  EXPECT_NEAR(outcome.cover_pct, 100.0 * 20.0 * 38.0 / 1600.0, 3.0);
}

TEST(SimulatedHits, AreTheSameForAnyNumberOfThreads) {
  TestSite site(flat(40, 40, 10));
  const RayScene scene(site.seafloor, Nodata::open);
  site.ground.scene = &scene;
  PlanOptions how = row_options(0.5, 1);
  how.threads = 1;
  const double alone = simulated_hits(one_line(17, 55), site.ground, how).cover_pct;
  how.threads = 3;
  EXPECT_EQ(simulated_hits(one_line(17, 55), site.ground, how).cover_pct, alone);
}

TEST(SimulatedHits, AWiderFanCoversMore) {
  TestSite site(flat(40, 40, 10));
  const RayScene scene(site.seafloor, Nodata::open);
  site.ground.scene = &scene;
  const PlanOptions how = row_options(0.5, 1);
  EXPECT_GT(simulated_hits(one_line(20, 55), site.ground, how).cover_pct,
            simulated_hits(one_line(20, 40), site.ground, how).cover_pct + 10.0);
}

}  // namespace
}  // namespace swathplan

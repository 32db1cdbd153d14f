#include "planners/fitted/fewest_hours.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "coverage/score.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/ends_after.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

PlanOptions survey_options() {
  PlanOptions options;
  options.pings.spacing_m.reset();
  options.counted = Counted::logged;
  options.angles = Angles::line;
  options.sonar.max_opening = Angle::degrees(130);
  options.resolution_m = 1.0;
  options.least_line_m = 20.0;
  options.vehicle.turn_radius_m = 4.0;
  return options;
}

TEST(FewestHours, LoggedLinesReachTheGoalInsideTheWater) {
  TestSite site(tilted(160.0, 90.0, 8.0, Angle::degrees(3.0)));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const PlanOptions options = survey_options();
  const Plan plan = plan_fewest_hours(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  ScoreOptions how;
  how.resolution_m = options.resolution_m;
  how.pings = options.pings;
  how.footprint = false;
  const Score score =
      swathplan::score(plan.route, site.ground, options.sonar, options.vehicle, how).score;
  EXPECT_GE(score.logged.hit_pct, 90.0);
  EXPECT_NEAR(score.logged.hit_pct, plan.choices.at(plan.chosen).cover_pct, 1e-9);
  EXPECT_LE(score.route.outside_water_m, 0.01);
  EXPECT_NEAR(score.route.duration_s, plan.choices[plan.chosen].duration_s, 1e-6);
  // Nothing is quicker and covers more.
  for (std::size_t i = 0; i + 1 < plan.choices.size(); ++i) {
    EXPECT_LT(plan.choices[i].cover_pct, plan.choices[i + 1].cover_pct);
  }
}

TEST(FewestHours, EachLineKeepsOneFanAndOneSpeedAndIsLongEnough) {
  TestSite site(stepped(120.0, 80.0, 6.0, 12.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const PlanOptions options = survey_options();
  const Route route = plan_fewest_hours(site.ground, options).route;
  std::map<int, std::set<double>> speeds, ports;
  for (const Waypoint& w : route.waypoints) {
    if (!w.line || !w.fan || w.kind != LegKind::line) continue;
    speeds[*w.line].insert(w.speed_mps);
    ports[*w.line].insert(w.fan->port.deg());
  }
  ASSERT_FALSE(speeds.empty());
  for (const auto& [line, values] : speeds) EXPECT_EQ(values.size(), 1U) << line;
  // A line that is turned round swaps its sides; it still has one angle a side.
  for (const auto& [line, values] : ports) EXPECT_EQ(values.size(), 1U) << line;
}

TEST(FewestHours, SaysWhereNoLineIsLongEnough) {
  TestSite site(flat(30.0, 20.0, 6.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions options = survey_options();
  options.least_line_m = 500.0;
  EXPECT_THROW((void)plan_fewest_hours(site.ground, options), InvalidInput);
}

// The same k gives the same plan, and nothing that was tried before is lost.
TEST(FewestHours, ASearchThatIsEndedKeepsTheBestPlanFinishedByThen) {
  TestSite site(tilted(160.0, 90.0, 8.0, Angle::degrees(3.0)));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const auto ended_after = [&](std::size_t candidates) {
    test::EndsAfter watcher(candidates);
    PlanOptions options = survey_options();
    options.watch = Watch(watcher);
    Plan plan = plan_fewest_hours(site.ground, options);
    EXPECT_EQ(watcher.count, candidates + 1);  // and one plan was finished
    EXPECT_EQ(watcher.phases, (std::vector<std::string>{"searching", "finishing the best"}));
    EXPECT_FALSE(watcher.bests.empty());
    EXPECT_EQ(plan.notes.back(),
              fmt::format("search ended early: the best of the {} tried by then was kept",
                          candidates == 1 ? "1 plan" : fmt::format("{} plans", candidates)));
    EXPECT_EQ(fault(plan.route), std::nullopt);
    return plan;
  };
  const Plan one = ended_after(1);
  const Plan three = ended_after(3);
  const Plan again = ended_after(3);
  ASSERT_EQ(three.route.waypoints.size(), again.route.waypoints.size());
  for (std::size_t i = 0; i < three.route.waypoints.size(); ++i) {
    EXPECT_EQ(three.route.waypoints[i].position, again.route.waypoints[i].position);
  }
  EXPECT_EQ(one.choices.size(), 1U);
  EXPECT_GT(one.choices[0].cover_pct, 50.0);
}

TEST(FewestHours, AWatcherThatNeverEndsTheSearchChangesNothing) {
  TestSite site(flat(60.0, 30.0, 8.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  test::EndsAfter watcher(1000000);
  PlanOptions watched = survey_options();
  watched.watch = Watch(watcher);
  const Plan with = plan_fewest_hours(site.ground, watched);
  const Plan without = plan_fewest_hours(site.ground, survey_options());
  EXPECT_EQ(with.notes, without.notes);
  EXPECT_EQ(positions(with.route.waypoints), positions(without.route.waypoints));
  EXPECT_GT(watcher.count, 10U);
}

TEST(FewestHours, AFarTooShortLimitIsKeptByAPartOfAPlan) {
  TestSite site(flat(120.0, 80.0, 8.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions options = survey_options();
  options.goal.length_m = 150.0;
  const Plan plan = plan_fewest_hours(site.ground, options);
  EXPECT_EQ(fault(plan.route), std::nullopt);
  EXPECT_LE(length_m(plan.route), 150.0);
  EXPECT_GT(length_m(plan.route), 75.0);
  EXPECT_EQ(plan.chosen_why, "the most coverage within 150 m of path");
  options.goal = {};
  options.goal.time_s = 60.0;
  const Plan timed = plan_fewest_hours(site.ground, options);
  EXPECT_LE(timed.choices.at(timed.chosen).duration_s, 60.0);
  EXPECT_GT(timed.choices[timed.chosen].cover_pct, 5.0);
}

}  // namespace
}  // namespace swathplan

#include "planners/fitted/fitted_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/score.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/ends_after.h"

namespace swathplan {
namespace {

struct ScoredSite {
  explicit ScoredSite(Seafloor floor, double run_out_m = 0.0)
      : seafloor(std::move(floor)), depths(seafloor), scene(seafloor, Nodata::wall) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.survey_area = survey_area(seafloor, {.limit = {}, .no_go = {}, .safe_depth_m = 0.8});
    ground.water = run_out_m > 0.0 ? offset(ground.survey_area, run_out_m) : ground.survey_area;
    ground.scene = &scene;
  }
  [[nodiscard]] Score score(const Route& route, const PlanOptions& options,
                            double swath_share = 1.0, const TrackNoise& noise = {}) const {
    ScoreOptions how;
    how.resolution_m = options.resolution_m;
    how.swath_share = swath_share;
    how.noise = noise;
    how.footprint = options.cover == Cover::footprint;
    return swathplan::score(route, ground, options.sonar, options.vehicle, how).score;
  }
  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  Ground ground;
};

PlanOptions quarter_metre() {
  PlanOptions options;
  options.resolution_m = 0.25;
  return options;
}

TEST(FittedLines, CoverTheSaddleBetterThanTheMeshPlannersAtLessPath) {
  const ScoredSite site(saddle(), 10.0);
  const PlanOptions options = quarter_metre();
  const Plan plan = plan_fitted_lines(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  const Score score = site.score(plan.route, options);
  // The mesh planner's 94.9 % take 2.9 ideal lengths.
  EXPECT_GE(score.all.hit_pct, 98.0);
  EXPECT_LE(score.route.length_ratio, 2.1);
  EXPECT_LE(score.route.outside_water_m, 0.01);
}

TEST(FittedLines, ABudgetMayHoldFarFewerRowsThanTheAreaAsksFor) {
  const ScoredSite site(flat(60.0, 60.0, 10.0), 10.0);
  PlanOptions options = quarter_metre();
  options.sonar.beams = 40;  // W = 10 m: six rows
  options.goal.length_m = 140.0;
  const Plan plan = plan_fitted_lines(site.ground, options);
  EXPECT_LE(length_m(plan.route), 140.0) << plan.chosen_why;
  EXPECT_LT(plan.choices[plan.chosen].cover_pct, 70.0);
}

TEST(FittedLines, NoFloorOfCoverageWhereNothingPassesIt) {
  const ScoredSite site(flat(60.0, 40.0, 10.0), 10.0);
  PlanOptions options = quarter_metre();
  options.pings.spacing_m = 4.0;  // one row of cells in sixteen
  const Plan plan = plan_fitted_lines(site.ground, options);
  EXPECT_EQ(fault(plan.route), std::nullopt);
  EXPECT_LT(plan.choices[plan.chosen].cover_pct, 70.0);
}

TEST(FittedLines, ChoicesRiseInLengthAndCoverageAndSayWhatTheScorerSays) {
  const ScoredSite site(stepped(32.0, 24.0, 5.0, 8.0));
  const PlanOptions options = quarter_metre();
  const Plan plan = plan_fitted_lines(site.ground, options);
  ASSERT_FALSE(plan.choices.empty());
  for (std::size_t i = 0; i + 1 < plan.choices.size(); ++i) {
    EXPECT_LT(plan.choices[i].length_ratio, plan.choices[i + 1].length_ratio);
    EXPECT_LT(plan.choices[i].cover_pct, plan.choices[i + 1].cover_pct);
  }
  const Score score = site.score(plan.route, options);
  ASSERT_LT(plan.chosen, plan.choices.size());
  EXPECT_NEAR(plan.choices[plan.chosen].cover_pct, score.all.hit_pct, 1e-9);
  EXPECT_NEAR(plan.choices[plan.chosen].length_ratio, score.route.length_ratio, 1e-9);
}

TEST(FittedLines, GiveWhatTheGoalAsksFor) {
  const ScoredSite site(flat(30.0, 24.0, 6.0));
  PlanOptions options = quarter_metre();
  options.goal.coverage_pct = 99.0;
  const Plan covered = plan_fitted_lines(site.ground, options);
  EXPECT_GE(site.score(covered.route, options).all.hit_pct, 99.0);
  options.goal = {.coverage_pct = {}, .length_m = 0.8 * length_m(covered.route), .time_s = {}};
  const Plan shorter = plan_fitted_lines(site.ground, options);
  EXPECT_LE(length_m(shorter.route), 0.8 * length_m(covered.route));
}

TEST(FittedLines, ForFootprintsLieFartherApartThanForHits) {
  const ScoredSite site(tilted(60.0, 40.0, 6.0, Angle::degrees(8.0)), 10.0);
  PlanOptions options = quarter_metre();
  options.resolution_m = 0.10;
  options.sonar.max_opening = Angle::degrees(130.0);
  options.goal.coverage_pct = 99.0;
  const Plan hits = plan_fitted_lines(site.ground, options);
  options.cover = Cover::footprint;
  const Plan plan = plan_fitted_lines(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  const Score score = site.score(plan.route, options);
  EXPECT_GE(score.all.footprint_pct.value(), 99.0);
  EXPECT_LT(length_m(plan.route), 0.8 * length_m(hits.route));
  ASSERT_LT(plan.chosen, plan.choices.size());
  EXPECT_EQ(plan.choices[plan.chosen].cover, Cover::footprint);
  EXPECT_NEAR(plan.choices[plan.chosen].cover_pct, score.all.footprint_pct.value(), 1e-9);
}

TEST(FittedLines, WithAMarginStillCoverWhereSwathsLoseIt) {
  const ScoredSite site(tilted(36.0, 28.0, 5.0, Angle::degrees(5.0)), 5.0);
  PlanOptions options = quarter_metre();
  options.goal.coverage_pct = 99.0;
  const Plan bare = plan_fitted_lines(site.ground, options);
  options.lines_margin = 0.2;
  const Plan plan = plan_fitted_lines(site.ground, options);
  const Outcome& chosen = plan.choices[plan.chosen];
  EXPECT_NEAR(chosen.whole_cover_pct.value(), site.score(plan.route, options).all.hit_pct, 1e-9);
  EXPECT_NEAR(chosen.cover_pct, site.score(plan.route, options, 0.8).all.hit_pct, 1e-9);
  EXPECT_GE(chosen.cover_pct, 99.0);
  // What it is bought from: neighbours of the plan without a margin just meet.
  EXPECT_LT(site.score(bare.route, options, 0.8).all.hit_pct, 95.0);
  EXPECT_FALSE(bare.choices[bare.chosen].whole_cover_pct.has_value());
}

TEST(FittedLines, AreJudgedWithTheNoiseThatIsExpected) {
  const ScoredSite site(tilted(36.0, 28.0, 5.0, Angle::degrees(5.0)), 5.0);
  PlanOptions options = quarter_metre();
  options.goal.coverage_pct = 99.0;
  options.noise.lateral_sigma_m = 0.5;
  const Plan plan = plan_fitted_lines(site.ground, options);
  const Outcome& chosen = plan.choices[plan.chosen];
  EXPECT_GE(chosen.cover_pct, 99.0);
  EXPECT_NEAR(chosen.cover_pct, site.score(plan.route, options, 1.0, options.noise).all.hit_pct,
              1e-9);
  TrackNoise other = options.noise;
  other.seed = 7;
  EXPECT_GE(site.score(plan.route, options, 1.0, other).all.hit_pct, 98.0);
}

TEST(FittedLines, AreTheSameForAnyNumberOfThreads) {
  const ScoredSite site(tilted(30.0, 20.0, 5.0, Angle::degrees(8.0)));
  PlanOptions options = quarter_metre();
  options.threads = 1;
  const Plan one = plan_fitted_lines(site.ground, options);
  options.threads = 2;
  const Plan two = plan_fitted_lines(site.ground, options);
  ASSERT_EQ(one.route.waypoints.size(), two.route.waypoints.size());
  for (std::size_t i = 0; i < one.route.waypoints.size(); ++i) {
    EXPECT_EQ(one.route.waypoints[i].position, two.route.waypoints[i].position);
    EXPECT_EQ(one.route.waypoints[i].fan, two.route.waypoints[i].fan);
  }
}

TEST(FittedLines, FieldLinesAloneCoverATiltedSeafloor) {
  const ScoredSite site(tilted(80.0, 60.0, 6.0, Angle::degrees(8.0)));
  PlanOptions options = quarter_metre();
  options.lines = LineSource::field;
  const Plan plan = plan_fitted_lines(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  EXPECT_GE(site.score(plan.route, options).all.hit_pct, 95.0);
}

TEST(FittedLines, NeedNoSceneForAFirstPlan) {
  ScoredSite site(flat(30.0, 24.0, 6.0));
  site.ground.scene = nullptr;
  const Plan plan = plan_fitted_lines(site.ground, quarter_metre());
  EXPECT_EQ(fault(plan.route), std::nullopt);
  EXPECT_TRUE(plan.choices.empty());
}

TEST(FittedLines, ASearchThatIsEndedKeepsTheBestPlanFinishedByThen) {
  const ScoredSite site(flat(60.0, 60.0, 10.0), 10.0);
  test::EndsAfter watcher(4);
  PlanOptions options = quarter_metre();
  options.watch = Watch(watcher);
  const Plan plan = plan_fitted_lines(site.ground, options);
  EXPECT_EQ(watcher.count, 5U);  // and one plan was finished
  EXPECT_EQ(plan.notes.back(),
            "search ended early: the best of the 1 finished plan tried by then was kept");
  EXPECT_EQ(fault(plan.route), std::nullopt);
  EXPECT_GT(site.score(plan.route, options).all.hit_pct, 50.0);
}

}  // namespace
}  // namespace swathplan

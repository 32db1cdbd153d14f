#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/report/verdict_internal.h"
#include "io/sample_judged.h"

namespace swathplan {
namespace {

using internal::ComparedPlan;
using testing::HasSubstr;
using testing::Not;

Holiday gap_of(std::size_t cells) {
  Holiday gap;
  gap.cells = cells;
  return gap;
}

Score surveyed() {
  Score score;
  score.logged_counts = true;
  score.all.hit_pct = 99.97;
  score.logged.hit_pct = 98.24;
  score.logged.hit_5_pct = 96.0;
  score.route.length_m = 6'620.0;
  score.route.duration_s = 57.0 * 60.0;
  score.least_hours = 0.66;
  return score;
}

TEST(Verdict, IsInASurveyorsWords) {
  Score score = surveyed();
  EXPECT_EQ(internal::verdict({"a", &score}),
            "57 min, 6.6 km, 98.2 % logged, 5 soundings in 96.0 % of cells. 1.44 times the least "
            "hours that the site can take.");
  score.least_hours.reset();
  score.logged_counts = false;
  EXPECT_THAT(internal::verdict({"a", &score}), HasSubstr("99.9 % covered by all pings, "));
  EXPECT_THAT(internal::verdict({"a", &score}), Not(HasSubstr("least")));
}

TEST(Verdict, SaysWhetherTheCriterionIsPredictedToPass) {
  const Score score = surveyed();
  JudgedSurvey judged = test::judged_survey();
  EXPECT_THAT(internal::verdict({"a", &score, &judged}),
              HasSubstr("of cells: predicted to fail IHO S-44 Special Order by coverage. 1.44"));
  judged.verdict.pass = true;
  EXPECT_THAT(internal::verdict({"a", &score, &judged}),
              HasSubstr("of cells: predicted to pass IHO S-44 Special Order. 1.44"));
}

TEST(Verdict, TellsGapsFromSpeckle) {
  Score score;
  EXPECT_EQ(internal::gaps_text(score), "No gaps.");
  score.holidays = {.count = 12345, .largest_m2 = 0.03, .total_m2 = 100.0, .list = {gap_of(3)}};
  EXPECT_EQ(internal::gaps_text(score), "No gaps but speckle of a cell or a few.");
  score.holidays.largest_m2 = 3.44;
  score.holidays.list = {gap_of(344), gap_of(2)};
  EXPECT_EQ(internal::gaps_text(score),
            "1 gap beside 12,344 smaller ones or speckle; the largest 3.4 m², between lines.");
  score.holidays.count = 1;
  score.holidays.list.pop_back();
  EXPECT_EQ(internal::gaps_text(score), "1 gap; the largest 3.4 m², between lines.");
}

TEST(Verdict, WarnsOfWhatMustNotBeSailedAndOfNothingElse) {
  Score score;
  score.route.min_under_keel_m = 0.5;
  score.route.self_crossings = 17;
  score.holidays.count = 5000;
  EXPECT_TRUE(internal::warnings(score).empty());
  score.route.outside_water_m = 0.24;
  score.route.min_under_keel_m = -0.5;
  score.route.infeasible_legs = 2;
  score.route.infeasible_m = 31.2;
  EXPECT_THAT(
      internal::warnings(score),
      testing::ElementsAre("Leaves the water for 0.2 m", "Runs aground: 0.50 m too little water",
                           "2 legs (32 m) cannot be steered in safe water"));
}

TEST(Verdict, TheBestPlanIsSoundThenPassesThenTakesTheFewestHours) {
  Score quick = surveyed(), dense = surveyed(), grounded = surveyed();
  quick.route.duration_s = 3000.0;
  quick.logged.hit_pct = 90.0;
  grounded.logged.hit_pct = 100.0;
  grounded.route.outside_water_m = 5.0;
  std::vector<ComparedPlan> plans{{"quick", &quick}, {"dense", &dense}, {"grounded", &grounded}};
  EXPECT_EQ(internal::best_plan(plans), 1U);
  EXPECT_EQ(internal::overall_verdict(plans), "The best of 3 plans is dense: the most coverage.");
  quick.goal = {.wanted_pct = 98.0, .covered_pct = 90.0};
  dense.goal = {.wanted_pct = 98.0, .covered_pct = 97.9};
  EXPECT_EQ(internal::best_plan(plans), 1U);
  EXPECT_EQ(internal::overall_verdict(plans),
            "The best of 3 plans is dense: the most coverage, as none reaches 98 % of the cells.");
  // Both reach it: a point more counts 1 % of the hours, 3,000 or 3,420 s.
  quick.goal->covered_pct = 98.1;
  dense.goal->covered_pct = 99.9;
  EXPECT_EQ(internal::best_plan(plans), 0U);
  EXPECT_THAT(internal::overall_verdict(plans),
              HasSubstr("is quick: the fewest hours that cover at least 98 % of the cells"));
  dense.route.duration_s = 3030.0;
  EXPECT_EQ(internal::best_plan(plans), 1U);
  quick.goal->covered_pct = dense.goal->covered_pct = 90.0;
  JudgedSurvey passes = test::judged_survey();
  passes.verdict.pass = true;
  plans[0].judged = plans[1].judged = &passes;
  EXPECT_EQ(internal::best_plan(plans), 0U);
  EXPECT_EQ(internal::overall_verdict({plans[0]}), "");
}

}  // namespace
}  // namespace swathplan

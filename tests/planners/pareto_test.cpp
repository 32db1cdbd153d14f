#include "planners/pareto.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace swathplan {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeats) {
  std::vector<Outcome> outcomes(5);
  const double ratio[] = {2.0, 1.5, 1.5, 3.0, 2.5};
  const double hit[] = {98.0, 96.0, 95.0, 97.0, 99.0};
  for (std::size_t i = 0; i < 5; ++i) {
    outcomes[i].length_ratio = ratio[i];
    outcomes[i].cover_pct = hit[i];
  }
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 0, 4}));
  EXPECT_TRUE(pareto_front({}).empty());
  // One that is longer or covers less, but can be steered, stays.
  outcomes[0].infeasible_legs = 1;
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 0, 4}));
  outcomes[0].infeasible_legs = 0;
  outcomes[1].infeasible_legs = 2;
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 2, 0, 4}));
}

TEST(ParetoPick, PrefersWhatCanBeSteered) {
  std::vector<Outcome> outcomes(2);
  outcomes[0].length_ratio = 2.48, outcomes[0].cover_pct = 98.2;
  outcomes[1].length_ratio = 2.50, outcomes[1].cover_pct = 99.3;
  EXPECT_EQ(pick(outcomes, {}).index, 1U);
  EXPECT_EQ(pick(outcomes, {}).why.find("infeasible"), std::string::npos);
  outcomes[1].infeasible_legs = 1;
  EXPECT_EQ(pick(outcomes, {}).index, 0U);
  EXPECT_NE(pick(outcomes, {}).why.find("infeasible"), std::string::npos);
  PlanGoal within;
  within.length_m = 1.0;
  outcomes[0].length_m = 248.0, outcomes[1].length_m = 250.0;
  const Pick shortest = pick(outcomes, within);
  EXPECT_EQ(shortest.index, 0U);
  EXPECT_NE(shortest.why.find("NOT within 1 m of path"), std::string::npos) << shortest.why;
}

TEST(ParetoPick, FollowsTheGoalAndSaysWhenItIsOutOfReach) {
  std::vector<Outcome> outcomes(3);
  for (std::size_t i = 0; i < 3; ++i) {
    outcomes[i].length_ratio = 1.0 + static_cast<double>(i);
    outcomes[i].length_m = 100.0 * outcomes[i].length_ratio;
    outcomes[i].duration_s = 50.0 * outcomes[i].length_ratio;
  }
  outcomes[0].cover_pct = 90.0;
  outcomes[1].cover_pct = 98.0;
  outcomes[2].cover_pct = 99.0;
  EXPECT_EQ(pick(outcomes, {}).index, 1U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = 98.5, .length_m = {}, .time_s = {}}).index, 2U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = {}, .length_m = 250.0, .time_s = {}}).index, 1U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = {}, .length_m = {}, .time_s = 60.0}).index, 0U);
  const Pick most = pick(outcomes, {.coverage_pct = 99.9, .length_m = {}, .time_s = {}});
  EXPECT_EQ(most.index, 2U);
  EXPECT_NE(most.why.find("no plan that was tried reaches"), std::string::npos);
}

TEST(ParetoPick, TakesMorePathWhereTheFanIsTooNarrow) {
  EXPECT_EQ(worth_per_ratio(1.2), kWorthPerRatio);
  EXPECT_EQ(worth_per_ratio(kUsualRatio), kWorthPerRatio);
  EXPECT_EQ(worth_per_ratio(2.0 * kUsualRatio), 0.5 * kWorthPerRatio);
  std::vector<Outcome> outcomes(2);
  outcomes[0].length_ratio = 3.0, outcomes[0].cover_pct = 91.7;
  outcomes[1].length_ratio = 5.0, outcomes[1].cover_pct = 97.5;
  EXPECT_EQ(pick(outcomes, {}).index, 0U);
  EXPECT_EQ(pick(outcomes, {}, worth_per_ratio(4.0)).index, 1U);
}

TEST(ParetoPick, ListsWhatLiesAboutTheGoal) {
  std::vector<Outcome> outcomes(4);
  for (std::size_t i = 0; i < 4; ++i) {
    outcomes[i].length_ratio = 1.0 + static_cast<double>(i);
    outcomes[i].cover_pct = 90.0 + 3.0 * static_cast<double>(i);
  }
  using List = std::vector<std::size_t>;
  const List front = pareto_front(outcomes);
  PlanGoal goal;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), List{});
  goal.coverage_pct = 95.0;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{2, 3, 1}));
  goal.coverage_pct = 50.0;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{0, 1}));
  goal.coverage_pct = 99.5;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{3, 2}));
  EXPECT_EQ(about_the_goal({}, {}, goal), List{});
}

TEST(Outcome, IsToldInALineOfATerminal) {
  Outcome outcome;
  outcome.cover_pct = 98.204;
  outcome.duration_s = 4464.0;
  outcome.length_m = 6620.4;
  EXPECT_EQ(brief(outcome), "98.20 % in 1.24 h, 6620 m");
}

}  // namespace
}  // namespace swathplan

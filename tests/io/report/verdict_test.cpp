#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/report/verdict_internal.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

TEST(Verdict, SaysCoverageLengthAndGaps) {
  Score score;
  score.all.hit_pct = 99.97;
  score.route.length_ratio = 3.4449;
  EXPECT_EQ(internal::verdict(score), "Covers 99.9 % at 3.44 times the ideal length. No gaps.");
  score.holidays = {.count = 12345, .largest_m2 = 3.44, .total_m2 = 1234.5, .list = {}};
  EXPECT_THAT(internal::verdict(score),
              HasSubstr("12,345 gaps, 1,234 m² in all; the largest 3.4 m²."));
  score.all.hit_pct = 100.0;
  EXPECT_EQ(internal::percent_text(score.all.hit_pct), "100.0");
}

TEST(Verdict, WarnsOfWhatMustNotBeSailed) {
  Score score;
  score.route.min_under_keel_m = 0.5;
  EXPECT_TRUE(internal::warnings(score).empty());
  score.route.outside_water_m = 0.24;
  score.route.min_under_keel_m = -0.5;
  score.route.self_crossings = 1;
  score.route.infeasible_legs = 2;
  score.route.infeasible_m = 31.2;
  EXPECT_THAT(internal::warnings(score),
              testing::ElementsAre(
                  "Leaves the water for 0.2 m", "Runs aground: 0.50 m too little water",
                  "2 legs (32 m) cannot be steered in safe water", "Crosses its own path 1 time"));
}

TEST(Verdict, NamesTheBestAndTheShortest) {
  Score a, b;
  a.all.hit_pct = 60.0;
  a.route.length_m = 10.0;
  b.all.hit_pct = 90.0;
  b.route.length_m = 30.0;
  EXPECT_THAT(internal::overall_verdict({"a", "b"}, {&a, &b}),
              testing::MatchesRegex("b .*covers most; a .*is the shortest."));
  b.route.length_m = 5.0;
  EXPECT_THAT(internal::overall_verdict({"a", "b"}, {&a, &b}),
              testing::MatchesRegex("b .*covers most and is the shortest."));
  EXPECT_EQ(internal::overall_verdict({"a"}, {&a}), "");
}

}  // namespace
}  // namespace swathplan

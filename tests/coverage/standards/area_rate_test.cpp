#include "coverage/standards/area_rate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// The prototype of docs/hours.md: 400 beams, 50 Hz, 130 degrees, cells of 1 m, 5 soundings, 4 m/s.
RateQuestion open_sea() {
  RateQuestion question;
  question.sonar.beams = 400;
  question.sonar.max_ping_rate_hz = 50.0;
  question.sonar.max_range_m = 600.0;
  return question;
}

double km2_per_hour(const AreaRate& rate) { return rate.rate_m2ps * 3600.0 / 1e6; }

struct RateRow {
  double depth_m, half_angle_deg, km2_per_hour;
};

TEST(AreaRate, IsThatOfThePrototype) {
  for (const RateRow& row : std::vector<RateRow>{
           {5, 65, 0.31}, {20, 65, 1.24}, {40, 53, 1.52}, {80, 34, 1.56}, {160, 14, 1.13}}) {
    const auto best = best_area_rate(open_sea(), row.depth_m);
    ASSERT_TRUE(best);
    EXPECT_NEAR(best->half_angle.deg(), row.half_angle_deg, 0.5) << row.depth_m;
    EXPECT_NEAR(km2_per_hour(*best), row.km2_per_hour, 0.005) << row.depth_m;
  }
}

TEST(AreaRate, FollowsTheClosedForms) {
  const auto rate = area_rate(open_sea(), 80.0, Angle::degrees(40));
  ASSERT_TRUE(rate);
  const double t = 40.0 * M_PI / 180.0;
  const double spacing = 2.0 * t * 80.0 / (399.0 * std::cos(t) * std::cos(t));
  const double interval = 2.0 * 80.0 / std::cos(t) / (0.9 * 1500.0);
  const double speed = 1.0 / (5.0 * spacing * interval);
  EXPECT_NEAR(rate->beam_spacing_m, spacing, 1e-12);
  EXPECT_NEAR(rate->ping_interval_s, interval, 1e-12);
  EXPECT_NEAR(rate->speed_mps, speed, 1e-12);
  EXPECT_NEAR(rate->rate_m2ps, 2.0 * 80.0 * speed * std::tan(t), 1e-9);
  EXPECT_EQ(rate->limit, RateLimit::soundings);
}

TEST(AreaRate, TellsWhatHoldsTheSpeed) {
  EXPECT_EQ(area_rate(open_sea(), 5.0, Angle::degrees(60))->limit, RateLimit::vehicle);
  RateQuestion fast = open_sea();
  fast.max_speed_mps = 10.0;
  fast.soundings = 0.1;
  EXPECT_EQ(area_rate(fast, 100.0, Angle::degrees(40))->limit, RateLimit::ping_spacing);
}

TEST(AreaRate, PingsTwiceInACycleWithADualSwath) {
  RateQuestion question = open_sea();
  const double single = area_rate(question, 100.0, Angle::degrees(30))->ping_interval_s;
  question.sonar.dual_swath = true;
  const auto dual = area_rate(question, 100.0, Angle::degrees(30));
  EXPECT_DOUBLE_EQ(dual->ping_interval_s, 0.5 * single);
}

TEST(AreaRate, EndsWithTheSonarsCoverageCurve) {
  RateQuestion question = open_sea();
  question.sonar.coverage_curve = {{10.0, Angle::degrees(60)}, {30.0, Angle::degrees(40)}};
  EXPECT_NEAR(best_area_rate(question, 20.0)->half_angle.deg(), 50.0, 1e-6);
  EXPECT_FALSE(area_rate(question, 20.0, Angle::degrees(51)));
}

TEST(AreaRate, SpreadsEquidistantBeamsEvenly) {
  RateQuestion question = open_sea();
  question.sonar.spacing = BeamSpacing::equidistant;
  EXPECT_NEAR(area_rate(question, 20.0, Angle::degrees(60))->beam_spacing_m,
              2.0 * 20.0 * std::sqrt(3.0) / 399.0, 1e-12);
}

TEST(AreaRate, NoFanIsBetterThanTheBest) {
  for (const double soundings : {0.5, 5.0, 20.0}) {
    for (const double depth : {3.0, 11.0, 37.0, 90.0, 250.0}) {
      RateQuestion question = open_sea();
      question.soundings = soundings;
      const auto best = best_area_rate(question, depth);
      ASSERT_TRUE(best);
      for (int tenth = 1; tenth <= 650; ++tenth) {
        const auto other = area_rate(question, depth, Angle::degrees(tenth / 10.0));
        if (other) {
          EXPECT_LE(other->rate_m2ps, best->rate_m2ps * (1.0 + 1e-6)) << depth;
        }
      }
    }
  }
}

TEST(AreaRate, NoFanServesWhereItReachesNothing) {
  RateQuestion question = open_sea();
  EXPECT_FALSE(area_rate(question, 590.0, Angle::degrees(30)));
  EXPECT_FALSE(best_area_rate(question, 601.0));
  EXPECT_FALSE(area_rate(question, 160.0, Angle::degrees(60)));  // beams farther apart than a cell
}

TEST(AreaRate, NarrowsTheFanForABoatThatCannotSteerSlowly) {
  RateQuestion question = open_sea();
  question.soundings = 0.5;
  const auto slow = best_area_rate(question, 300.0);
  ASSERT_TRUE(slow);
  question.least_speed_mps = 1.1 * slow->speed_mps;
  const auto narrow = best_area_rate(question, 300.0);
  ASSERT_TRUE(narrow);
  EXPECT_GE(narrow->speed_mps, question.least_speed_mps);
  EXPECT_LT(narrow->half_angle, slow->half_angle);
  question.least_speed_mps = 3.0;  // one ping a cell allows 2.25 m/s straight down
  EXPECT_FALSE(best_area_rate(question, 300.0));
}

TEST(AreaRate, RefusesWhatMakesNoSense) {
  RateQuestion question = open_sea();
  EXPECT_THROW((void)best_area_rate(question, 0.0), UsageError);
  EXPECT_THROW((void)area_rate(question, 10.0, Angle::degrees(90)), UsageError);
  question.max_speed_mps = 0.0;
  EXPECT_THROW((void)best_area_rate(question, 10.0), UsageError);
  question = open_sea();
  question.soundings = -1.0;
  EXPECT_THROW((void)best_area_rate(question, 10.0), UsageError);
}

TEST(LeastHours, OfALevelFloorAreItsAreaOverTheRate) {
  const std::vector<DepthArea> floor{{20.0, 3e6}, {20.0, 1e6}};
  const LeastHours least = least_hours(open_sea(), floor);
  EXPECT_NEAR(least.hours, 4.0 / km2_per_hour(*best_area_rate(open_sea(), 20.0)), 1e-9);
  EXPECT_DOUBLE_EQ(least.area_m2, 4e6);
}

TEST(LeastHours, OfASlopeAreTheIntegral) {
  std::vector<DepthArea> slope;
  double hours = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double depth = 20.0 + 180.0 * (i + 0.5) / 20000.0;
    slope.push_back({depth, 100.0});
    if (i % 20 == 10) hours += 2000.0 / best_area_rate(open_sea(), depth)->rate_m2ps / 3600.0;
  }
  EXPECT_NEAR(least_hours(open_sea(), slope).hours, hours, 1e-3 * hours);
}

TEST(LeastHours, SayWhereNoFanReaches) {
  const std::vector<DepthArea> places{{20.0, 1e4}, {700.0, 5e3}, {900.0, 1e3}, {-1.0, 7.0}};
  const LeastHours least = least_hours(open_sea(), places);
  EXPECT_DOUBLE_EQ(least.area_m2, 1e4);
  EXPECT_DOUBLE_EQ(least.unreachable_m2, 6e3);
  EXPECT_NEAR(least.shoalest_unreachable_m, 700.0, 1e-9);
  EXPECT_NEAR(least.deepest_m, 20.0, 1e-9);
}

TEST(LeastHours, OfNoGroundAreNone) { EXPECT_EQ(least_hours(open_sea(), {}).hours, 0.0); }

}  // namespace
}  // namespace swathplan

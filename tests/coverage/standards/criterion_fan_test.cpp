#include "coverage/standards/criterion_fan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// A sonar, positions and motion that are known well enough for the open sea.
struct FanCase {
  Sonar sonar = *sonar_preset("em2040");
  UncertaintyBudget budget;

  FanCase() {
    use_sonar(sonar.name, budget);
    use_positioning("rtk", budget);
    use_motion_sensor("mru", budget);
    budget.beam_width_along = sonar.beam_width_along;
    budget.mean_sound_speed_mps = 1.0;
    budget.head_sound_speed_mps = 0.25;
    budget.draft_m = budget.squat_m = 0.02;
  }
  [[nodiscard]] std::optional<Angle> widest(const char* name, double depth) const {
    return accepted_half_angle(criterion(name), UncertaintyModel(budget), sonar, depth, 1.0, 4.0,
                               Angle::degrees(70));
  }
};

TEST(CriterionFan, EndsWhereTheFirstLimitIsMet) {
  const FanCase c;
  for (const char* name : {"s44-exclusive", "s44-special", "s44-1a", "noaa-object-detection"}) {
    for (const double depth : {10.0, 40.0, 90.0}) {
      const auto half = c.widest(name, depth);
      if (!half) continue;
      const auto accepted = [&](double degrees) {
        const Angle t = Angle::degrees(degrees);
        const SoundingUncertainty known = sounding_uncertainty(c.budget, {t, depth / cos(t), 4.0});
        const auto cube = feature_m(criterion(name), depth + 1.0);
        return known.tvu_m <= tvu_limit_m(criterion(name), depth + 1.0) &&
               known.thu_m <= thu_limit_m(criterion(name), depth + 1.0) &&
               (!cube || edge_beam_spacing_m(c.sonar, depth, t) <= *cube / 3.0);
      };
      EXPECT_TRUE(accepted(half->deg())) << name << depth;
      if (half->deg() < 70.0) {
        EXPECT_FALSE(accepted(half->deg() + 0.011)) << name << depth;
      }
    }
  }
}

TEST(CriterionFan, NarrowsForAStricterOrderAndForAWorseSensor) {
  FanCase c;
  EXPECT_LT(*c.widest("s44-special", 40), *c.widest("s44-1a", 40));
  const Angle before = *c.widest("s44-special", 40);
  use_motion_sensor("ahrs", c.budget);
  EXPECT_LT(*c.widest("s44-special", 40), before);
}

TEST(CriterionFan, IsNoneWhereNotEvenNadirIsKnownWellEnough) {
  FanCase c;
  c.budget.water_level_m = 0.2;
  EXPECT_FALSE(c.widest("s44-special", 10));
  EXPECT_TRUE(c.widest("s44-1a", 10));
}

TEST(CriterionFan, AsksForTheCriterionsCellSoundingsAndStrikes) {
  const FanCase c;
  RateQuestion question;
  question.sonar = c.sonar;
  const auto asked =
      asked_by(criterion("s44-special"), UncertaintyModel(c.budget), question, 20.0, 1.0);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->cell_m, 0.5);
  EXPECT_EQ(asked->soundings, 5.0);
  EXPECT_NEAR(*asked->ping_spacing_m, 1.0 / 3.0, 1e-12);
  const auto best = best_area_rate(*asked, 20.0);
  ASSERT_TRUE(best);
  EXPECT_LE(best->half_angle, *c.widest("s44-special", 20));
  EXPECT_LE(best->speed_mps * best->ping_interval_s, 1.0 / 3.0 + 1e-9);
  EXPECT_LT(best->rate_m2ps, best_area_rate(question, 20.0)->rate_m2ps);
}

TEST(CriterionFan, NarrowsASonarByDepthAndNeverOpensIt) {
  FanCase c;
  c.sonar.coverage_curve = {{5.0, Angle::degrees(65)}, {25.0, Angle::degrees(45)}};
  const UncertaintyModel model(c.budget);
  const Criterion& order = criterion("s44-special");
  const Sonar narrow = narrowed_to(order, model, c.sonar, {2.0, 200.0}, 1.0, 4.0);
  ASSERT_GT(narrow.coverage_curve.size(), 10U);
  for (std::size_t i = 0; i < narrow.coverage_curve.size(); ++i) {
    const auto [depth, half] = narrow.coverage_curve[i];
    if (i > 0) {
      EXPECT_LE(half, narrow.coverage_curve[i - 1].half_angle);
      EXPECT_GT(depth, narrow.coverage_curve[i - 1].depth_m);
    }
    const auto accepted = c.widest("s44-special", depth);
    EXPECT_LE(half.deg(), accepted ? accepted->deg() + 0.01 : 0.0) << depth;
    EXPECT_LE(reach_m(narrow, half), reach_m(c.sonar, half) + 1e-9) << depth;
  }
  // Where the sonar's own curve is what ends the fan.
  EXPECT_NEAR(narrow.coverage_curve.front().half_angle.deg(), 65.0, 0.01);
}

TEST(CriterionFan, NarrowsForGroundOfOneDepth) {
  const FanCase c;
  const Sonar narrow = narrowed_to(criterion("s44-special"), UncertaintyModel(c.budget), c.sonar,
                                   {20.0, 20.0}, 1.0, 4.0);
  ASSERT_EQ(narrow.coverage_curve.size(), 1U);
  EXPECT_EQ(narrow.coverage_curve[0].half_angle, *c.widest("s44-special", 20.0));
}

TEST(CriterionFan, RefusesWhatMakesNoSense) {
  const FanCase c;
  EXPECT_THROW((void)c.widest("s44-1a", 0.0), UsageError);
}

}  // namespace
}  // namespace swathplan

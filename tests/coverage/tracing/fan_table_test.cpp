#include "coverage/tracing/fan_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace swathplan {
namespace {

FanAngles table_fan(double half_deg) {
  return {Angle::degrees(half_deg), Angle::degrees(half_deg)};
}

TEST(FanTable, HoldsTheBeamsOfTheSonarInTheirOrder) {
  Sonar sonar;
  sonar.beams = 61;
  const FanAngles fan{Angle::degrees(30), Angle::degrees(60)};
  const FanTable table(sonar, fan);
  const std::vector<double> angles = beam_angles_rad(sonar, fan);
  ASSERT_EQ(table.beams, angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    EXPECT_NEAR(std::atan2(table.sine[i], table.cosine[i]), angles[i], 1e-6);
    EXPECT_NEAR(table.step[i], Angle::degrees(1.5).rad(), 1e-6);
    EXPECT_NEAR(table.next_step[i], Angle::degrees(1.5).rad(), 1e-6);
  }
}

TEST(FanTable, StepsOfUnevenBeamsAreThoseToTheirNeighbours) {
  Sonar sonar;
  sonar.beams = 5;
  sonar.spacing = BeamSpacing::equidistant;
  const FanTable table(sonar, table_fan(60));
  const std::vector<double> angles = beam_angles_rad(sonar, table_fan(60));
  EXPECT_NEAR(table.step[0], angles[1] - angles[0], 1e-6);
  EXPECT_NEAR(table.next_step[4], angles[4] - angles[3], 1e-6);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(table.step[i], angles[i] - angles[i - 1], 1e-6);
    EXPECT_NEAR(table.next_step[i], angles[i + 1] - angles[i], 1e-6);
  }
}

TEST(FanTable, IsPaddedToWholePacketsThatGiveNoStep) {
  Sonar sonar;
  for (const int beams : {2, 7, 8, 9, 17}) {
    sonar.beams = beams;
    const FanTable table(sonar, table_fan(45));
    ASSERT_EQ(table.beams, static_cast<std::size_t>(beams));
    EXPECT_GE(table.padded, table.beams);
    for (const auto* row :
         {&table.sine, &table.cosine, &table.step, &table.reach, &table.next_step}) {
      EXPECT_EQ(row->size(), table.padded);
    }
    for (std::size_t i = table.beams; i < table.padded; ++i) EXPECT_EQ(table.step[i], 0.0F);
  }
}

TEST(FanTable, AShareOfTheSwathDropsTheOuterBeams) {
  Sonar sonar;
  sonar.beams = 101;
  sonar.spacing = BeamSpacing::equidistant;
  const FanTable table(sonar, table_fan(60), 0.505);
  // Beams lie 2 % of the half swath apart: 25 to either side and the one below the keel are left.
  EXPECT_EQ(table.beams, 51U);
  const double outermost = std::atan2(table.sine[0], table.cosine[0]);
  EXPECT_NEAR(std::tan(outermost), -0.5 * std::tan(Angle::degrees(60).rad()), 1e-5);
}

TEST(FanTable, OnlyACoverageCurveLimitsTheReach) {
  Sonar sonar;
  EXPECT_EQ(FanTable(sonar, table_fan(60)).reach[0], std::numeric_limits<float>::max());
  sonar.coverage_curve = {{.depth_m = 20.0, .half_angle = Angle::degrees(50)}};
  const FanTable table(sonar, table_fan(60));
  EXPECT_EQ(table.reach[0], 0.0F);
  EXPECT_NEAR(table.reach[table.beams / 2], sonar.max_range_m, 1e-3);
}

TEST(FanTableCache, AnswersAsAFreshTableHoweverManyFansAreAsked) {
  Sonar sonar;
  sonar.beams = 16;
  FanTableCache cache(sonar, 0.9);
  // More fans than it keeps, asked again in turn and back.
  for (const int round : {0, 1, 2}) {
    for (int k = 0; k < 20; ++k) {
      const FanAngles fan = table_fan(20.0 + (round == 1 ? 19 - k : k));
      const FanTable& cached = cache.get(fan);
      const FanTable fresh(sonar, fan, 0.9);
      EXPECT_EQ(cached.fan, fan);
      EXPECT_EQ(cached.sine, fresh.sine);
      EXPECT_EQ(&cache.get(fan), &cached);
    }
  }
}

}  // namespace
}  // namespace swathplan

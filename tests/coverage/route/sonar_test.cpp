#include "coverage/route/sonar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace swathplan {
namespace {

constexpr FanAngles uneven_fan() { return {Angle::degrees(40), Angle::degrees(65)}; }

TEST(Sonar, PresetsAreFoundByTheirOwnNamesOnly) {
  std::set<std::string> names;
  for (const Sonar& preset : sonar_presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    const auto found = sonar_preset(preset.name);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->beams, preset.beams);
    EXPECT_GE(preset.beams, 2);
    EXPECT_GT(preset.max_opening.deg(), 0.0);
    EXPECT_LT(preset.max_opening.deg(), 180.0);
  }
  EXPECT_FALSE(sonar_preset("").has_value());
  EXPECT_FALSE(sonar_preset("NORBIT-IWBMS").has_value());
}

TEST(Sonar, AHalfAngleSweepsTheWidthAskedForUpToTheFansEnd) {
  const Sonar sonar{.max_opening = Angle::degrees(140)};
  EXPECT_NEAR(half_angle(sonar, 20.0, 10.0).deg(), 45.0, 1e-9);
  for (const double depth : {5.0, 12.0, 80.0}) {
    EXPECT_NEAR(2.0 * depth * tan(half_angle(sonar, 25.6, depth)), 25.6, 1e-9) << depth;
  }
  EXPECT_DOUBLE_EQ(half_angle(sonar, 100.0, 1.0).deg(), 70.0);
  EXPECT_DOUBLE_EQ(half_angle(sonar, 100.0, 0.0).deg(), 70.0);
}

TEST(Sonar, TheGapFreeAngleIsTheLargestWithOutermostBeamsACellApart) {
  const Sonar sonar;
  for (const double depth : {4.0, 10.0, 30.0}) {
    const double t = gap_free_half_angle(sonar, depth, 0.2).rad();
    ASSERT_LT(t, sonar.max_opening.rad() / 2.0);
    // What one step between beams covers on flat ground at the fan's end.
    const double apart = 2.0 * t / (sonar.beams - 1) * depth / (std::cos(t) * std::cos(t));
    EXPECT_NEAR(apart, 0.2, 1e-9) << depth;
  }
  EXPECT_DOUBLE_EQ(gap_free_half_angle(sonar, 0.5, 10.0).deg(), 80.0);
}

TEST(Sonar, EquiangularBeamsStandEvenAnglesApartFromEdgeToEdge) {
  Sonar sonar;
  sonar.beams = 22;
  const std::vector<double> angles = beam_angles_rad(sonar, uneven_fan());
  ASSERT_EQ(angles.size(), 22U);
  EXPECT_NEAR(angles.front(), -uneven_fan().port.rad(), 1e-12);
  EXPECT_NEAR(angles.back(), uneven_fan().starboard.rad(), 1e-12);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    EXPECT_NEAR(angles[i] - angles[i - 1], Angle::degrees(5).rad(), 1e-12);
  }
}

TEST(Sonar, EquidistantBeamsHitLevelGroundAtEvenDistances) {
  Sonar sonar;
  sonar.beams = 33;
  sonar.spacing = BeamSpacing::equidistant;
  const std::vector<double> angles = beam_angles_rad(sonar, uneven_fan());
  const double step = (tan(uneven_fan().port) + tan(uneven_fan().starboard)) / 32.0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    EXPECT_NEAR(std::tan(angles[i]) - std::tan(angles[i - 1]), step, 1e-12);
  }
}

TEST(Sonar, WithoutACurveEveryBeamReachesTheRange) {
  const Sonar sonar{.max_range_m = 120.0};
  EXPECT_EQ(reach_m(sonar, Angle::degrees(0)), 120.0);
  EXPECT_EQ(reach_m(sonar, Angle::degrees(-79)), 120.0);
}

TEST(Sonar, ACoverageCurveEndsTheReachAtTheDepthWhereTheBeamIsLost) {
  Sonar sonar;
  sonar.max_range_m = 1000.0;
  sonar.coverage_curve = {{.depth_m = 50.0, .half_angle = Angle::degrees(70)},
                          {.depth_m = 150.0, .half_angle = Angle::degrees(30)}};
  // Halfway between the limits' angles the depth lies halfway too, to either side.
  const double reach = 100.0 / cos(Angle::degrees(50));
  EXPECT_NEAR(reach_m(sonar, Angle::degrees(50)), reach, 1e-9);
  EXPECT_NEAR(reach_m(sonar, Angle::degrees(-50)), reach, 1e-9);
  EXPECT_EQ(reach_m(sonar, Angle::degrees(75)), 0.0);     // lost at every depth of the curve
  EXPECT_EQ(reach_m(sonar, Angle::degrees(20)), 1000.0);  // never lost by the curve
  sonar.max_range_m = 60.0;
  EXPECT_EQ(reach_m(sonar, Angle::degrees(50)), 60.0);
}

}  // namespace
}  // namespace swathplan

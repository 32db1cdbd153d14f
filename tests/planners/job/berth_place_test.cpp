#include "planners/job/berth_place.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

TEST(BerthPlace, InSafeWaterItIsTheBerthItself) {
  const JobSite bench;
  const BerthPlace found = berth_place({300, 20}, bench.site.ground, bench.how.vehicle);
  EXPECT_EQ(found.lies, BerthPlace::Lies::in_safe_water);
  EXPECT_EQ(found.place, Vec2(300, 20));
  EXPECT_EQ(found.apart_m, 0.0);
}

TEST(BerthPlace, BesideAWallTheBoatLiesOffItByTheClearance) {
  JobSite bench;
  bench.how.vehicle.clearance_m = 3.0;
  bench.site.ground.water = offset(bench.site.ground.survey_area, -3.0);
  const BerthPlace found = berth_place({300, 1}, bench.site.ground, bench.how.vehicle);
  EXPECT_EQ(found.lies, BerthPlace::Lies::beside_it);
  EXPECT_NEAR(found.apart_m, 2.1, 0.05);
  EXPECT_TRUE(contains(bench.site.ground.water, found.place));
}

TEST(BerthPlace, OnLandItIsOffAndTheNearestSafeWaterIsNamed) {
  const JobSite bench;
  const BerthPlace found = berth_place({300, -40}, bench.site.ground, bench.how.vehicle);
  EXPECT_EQ(found.lies, BerthPlace::Lies::off_it);
  EXPECT_NEAR(found.apart_m, 40.1, 0.01);
}

TEST(BerthPlace, ShoalWaterIsNoBerth) {
  const JobSite bench(tilted(200, 100, 0.2, Angle::degrees(2)));
  const BerthPlace found = berth_place({1, 50}, bench.site.ground, bench.how.vehicle);
  // All water counts as safe there, so the boat may lie in it; with the shoal cut off it may not.
  EXPECT_EQ(found.lies, BerthPlace::Lies::in_safe_water);
  JobSite cut(tilted(200, 100, 0.2, Angle::degrees(2)));
  cut.site.ground.water =
      intersect(cut.site.ground.water, Area{{{{50, 0}, {200, 0}, {200, 100}, {50, 100}}, {}}});
  EXPECT_EQ(berth_place({1, 50}, cut.site.ground, cut.how.vehicle).lies, BerthPlace::Lies::off_it);
}

}  // namespace
}  // namespace swathplan

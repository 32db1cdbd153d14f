#include "coverage/route/ping_clock.h"

#include <gtest/gtest.h>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

Sonar sonar_of(double rate_hz, bool dual) {
  Sonar sonar;
  sonar.max_ping_rate_hz = rate_hz;
  sonar.dual_swath = dual;
  sonar.max_range_m = 300.0;
  return sonar;
}

constexpr PingTiming kByClock{.spacing_m = std::nullopt};

TEST(PingClock, WaitsForTheFarthestSounding) {
  const Sonar sonar = sonar_of(40.0, false);
  // 2 x 135 m / (0.9 x 1500 m/s).
  EXPECT_NEAR(ping_interval_s(sonar, kByClock, 135.0), 0.2, 1e-12);
  EXPECT_TRUE(sound_binds(sonar, kByClock, 135.0));
  EXPECT_NEAR(most_cycles_hz(kByClock, 135.0), 5.0, 1e-12);
}

TEST(PingClock, IsNoFasterThanTheSonar) {
  const Sonar sonar = sonar_of(40.0, false);
  EXPECT_NEAR(ping_interval_s(sonar, kByClock, 5.0), 0.025, 1e-12);
  EXPECT_FALSE(sound_binds(sonar, kByClock, 5.0));
}

TEST(PingClock, TwoFansACycleHalveTheInterval) {
  for (const double range : {5.0, 135.0}) {
    EXPECT_NEAR(ping_interval_s(sonar_of(40.0, true), kByClock, range),
                0.5 * ping_interval_s(sonar_of(40.0, false), kByClock, range), 1e-12);
  }
}

TEST(PingClock, SpacingFollowsDepthFanAndSpeed) {
  const Sonar sonar = sonar_of(40.0, false);
  // A fan of 60 degrees to a side reaches twice the depth.
  EXPECT_NEAR(ping_spacing_m(sonar, kByClock, 67.5, Angle::degrees(60), 2.0), 0.4, 1e-9);
  EXPECT_NEAR(ping_spacing_m(sonar, kByClock, 67.5, Angle::degrees(60), 4.0), 0.8, 1e-9);
  // Beyond its range no sonar waits.
  EXPECT_NEAR(ping_spacing_m(sonar, kByClock, 1000.0, Angle::degrees(60), 2.0),
              2.0 * ping_interval_s(sonar, kByClock, 300.0), 1e-9);
  EXPECT_DOUBLE_EQ(ping_spacing_m(sonar, {.spacing_m = 0.1}, 67.5, Angle::degrees(60), 2.0), 0.1);
}

TEST(PingClock, RefusesWhatCannotBe) {
  EXPECT_THROW(check(sonar_of(0.0, false), kByClock), UsageError);
  EXPECT_THROW(check(sonar_of(40.0, false), {.spacing_m = 0.0}), UsageError);
  EXPECT_THROW(check(sonar_of(40.0, false), {.sound_speed_mps = -1500.0}), UsageError);
  EXPECT_THROW(check(sonar_of(40.0, false), {.thinning = 0.5}), UsageError);
  EXPECT_NO_THROW(check(sonar_of(40.0, false), kByClock));
}

}  // namespace
}  // namespace swathplan

#include "coverage/route/pings.h"

#include <gtest/gtest.h>

#include "coverage/scenes.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

const FanAngles kFan{Angle::degrees(60), Angle::degrees(50)};

std::vector<Ping> all_pings(const Route& route, double spacing, const TrackNoise& noise = {},
                            std::size_t block = 7) {
  const Sonar sonar;
  PingWalker walker(route, sonar, {.spacing_m = spacing}, noise);
  std::vector<Ping> result;
  std::vector<Ping> part;
  while (walker.next(block, part)) {
    EXPECT_LE(part.size(), block);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

TEST(PingWalker, StandsAtEverySpacingOnThroughWaypoints) {
  // Segments of 1.05, 2.0 and 0.33 m: pings run on without restart.
  const Route route = testing::route_through({{0, 0}, {1.05, 0}, {1.05, 2.0}, {0.72, 2.0}}, kFan);
  const auto pings = all_pings(route, 0.1);
  ASSERT_EQ(pings.size(), 34U);
  for (std::size_t k = 0; k < pings.size(); ++k) {
    const double s = 0.1 * static_cast<double>(k);
    Vec2 expected(s, 0);
    if (s >= 1.05) expected = {1.05, s - 1.05};
    if (s >= 3.05) expected = {1.05 - (s - 3.05), 2.0};
    EXPECT_LT((pings[k].position - expected).norm(), 1e-9) << k;
  }
  EXPECT_EQ(pings[10].course, Vec2(1, 0));
  EXPECT_EQ(pings[11].course, Vec2(0, 1));
}

TEST(PingWalker, RoundingNeitherDropsNorAddsTheLastPing) {
  for (const int n : {1, 3, 7, 29, 801, 12345}) {
    const double length = 0.1 * n;  // not a sum of tenths in binary
    std::vector<Vec2> points;
    for (int i = 0; i <= 10; ++i) points.emplace_back(1234.567 + length * i / 10.0, 0.3);
    EXPECT_EQ(all_pings(testing::route_through(points, kFan), 0.1).size(),
              static_cast<std::size_t>(n) + 1)
        << n;
  }
}

TEST(PingWalker, APingOnAWaypointBelongsToTheNextSegment) {
  Route route = testing::route_through({{0, 0}, {1, 0}, {1, 1}}, kFan);
  route.waypoints[1].log = false;
  const auto pings = all_pings(route, 0.5);
  ASSERT_EQ(pings.size(), 5U);
  EXPECT_EQ(pings[2].course, Vec2(0, 1));
  EXPECT_FALSE(pings[2].log);
  EXPECT_EQ(pings[1].leg, 0U);
  EXPECT_EQ(pings[2].leg, 1U);
  EXPECT_EQ(pings[4].course, Vec2(0, 1));
}

TEST(PingWalker, ALegWithTheSonarOffGivesNoPingsButTheCountRunsOn) {
  Route route = testing::route_through({{0, 0}, {1.05, 0}, {2.0, 0}, {3.0, 0}}, kFan);
  route.waypoints[1].fan.reset();
  const auto pings = all_pings(route, 0.1);
  ASSERT_EQ(pings.size(), 11U + 11U);
  EXPECT_NEAR(pings[10].position.x(), 1.0, 1e-9);
  EXPECT_NEAR(pings[11].position.x(), 2.0, 1e-9);
}

TEST(PingWalker, BlocksDoNotMatter) {
  const Route route = testing::route_through({{0, 0}, {31, 4}, {7, 50}}, kFan);
  TrackNoise noise;
  noise.lateral_sigma_m = 0.5;
  const auto one = all_pings(route, 0.13, noise, 1);
  const auto many = all_pings(route, 0.13, noise, 1000000);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, many[i].position);
}

struct Moments {
  double mean = 0.0, variance = 0.0, lag = 0.0;
};

Moments moments(const std::vector<double>& x, std::size_t lag) {
  Moments m;
  for (const double v : x) m.mean += v / static_cast<double>(x.size());
  for (const double v : x)
    m.variance += (v - m.mean) * (v - m.mean) / static_cast<double>(x.size());
  for (std::size_t i = lag; i < x.size(); ++i) {
    m.lag += (x[i] - m.mean) * (x[i - lag] - m.mean) / static_cast<double>(x.size() - lag);
  }
  return m;
}

TEST(TrackNoise, HasItsSigmasAndForgetsOverItsLength) {
  const Route route = testing::route_through({{0, 0}, {0, 60000}}, kFan);
  TrackNoise noise;
  noise.lateral_sigma_m = 0.8;
  noise.heading_sigma = Angle::degrees(3);
  noise.roll_sigma = Angle::degrees(2);
  noise.heave_sigma_m = 0.2;
  noise.correlation_length_m = 5.0;
  const auto pings = all_pings(route, 0.5, noise, 4096);
  std::vector<double> lateral, heading, roll, heave;
  for (const Ping& p : pings) {
    lateral.push_back(p.position.x());
    heading.push_back(std::atan2(p.course.x(), p.course.y()));
    roll.push_back(p.roll.rad());
    heave.push_back(p.heave_m);
    EXPECT_NEAR(p.course.norm(), 1.0, 1e-12);
  }
  const auto expect = [](const std::vector<double>& x, double sigma) {
    const Moments m = moments(x, 10);  // one correlation length
    EXPECT_NEAR(m.mean / sigma, 0.0, 0.05);
    EXPECT_NEAR(std::sqrt(m.variance) / sigma, 1.0, 0.05);
    EXPECT_NEAR(m.lag / m.variance, std::exp(-1.0), 0.05);
  };
  expect(lateral, 0.8);
  expect(heading, Angle::degrees(3).rad());
  expect(roll, Angle::degrees(2).rad());
  expect(heave, 0.2);
}

TEST(TrackNoise, IsStationaryFromTheFirstPing) {
  const Route route = testing::route_through({{0, 0}, {0, 1}}, kFan);
  TrackNoise noise;
  noise.lateral_sigma_m = 2.0;
  std::vector<double> first;
  for (noise.seed = 0; noise.seed < 4000; ++noise.seed) {
    first.push_back(all_pings(route, 5.0, noise).front().position.x());
  }
  EXPECT_NEAR(std::sqrt(moments(first, 1).variance), 2.0, 0.1);
}

TEST(TrackNoise, TheSeedDecidesAndOneErrorLeavesTheOthersAlone) {
  const Route route = testing::route_through({{0, 0}, {40, 60}}, kFan);
  TrackNoise noise;
  noise.lateral_sigma_m = 0.5;
  noise.seed = 42;
  const auto a = all_pings(route, 0.5, noise);
  noise.roll_sigma = Angle::degrees(5);
  const auto b = all_pings(route, 0.5, noise);
  noise.seed = 43;
  const auto c = all_pings(route, 0.5, noise);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
  EXPECT_NE(b.back().position, c.back().position);
}

TEST(PingWalker, RefusesWhatMakesNoSense) {
  const Route route = testing::route_through({{0, 0}, {40, 60}}, kFan);
  const Sonar sonar;
  for (const double spacing : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(PingWalker(route, sonar, {.spacing_m = spacing}, {}), UsageError);
  }
  TrackNoise noise;
  noise.lateral_sigma_m = -1;
  EXPECT_THROW(PingWalker(route, sonar, {.spacing_m = 1.0}, noise), UsageError);
  noise.lateral_sigma_m = 1;
  noise.correlation_length_m = 0;
  EXPECT_THROW(PingWalker(route, sonar, {.spacing_m = 1.0}, noise), UsageError);
}

// Pings by the clock whose farthest sounding always lies as far.
std::vector<Ping> clock_pings(const Route& route, const Sonar& sonar, double range_m,
                              PingTiming timing = {.spacing_m = {}}) {
  PingWalker walker(route, sonar, timing, {});
  std::vector<Ping> result;
  std::vector<Ping> part;
  while (walker.next(5, part, [&](const Ping&) { return range_m; })) {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

TEST(PingClock, TheLargestRateBindsInShoalWaterAndTheWayOfTheSoundInDeepWater) {
  Sonar sonar;
  sonar.max_ping_rate_hz = 50.0;
  const PingTiming timing{.spacing_m = {}};
  EXPECT_DOUBLE_EQ(ping_interval_s(sonar, timing, 10.0), 1.0 / 50.0);
  EXPECT_FALSE(sound_binds(sonar, timing, 10.0));
  EXPECT_DOUBLE_EQ(ping_interval_s(sonar, timing, 135.0), 2.0 * 135.0 / (0.9 * 1500.0));
  EXPECT_TRUE(sound_binds(sonar, timing, 135.0));
  sonar.dual_swath = true;
  EXPECT_DOUBLE_EQ(ping_interval_s(sonar, timing, 135.0), 135.0 / (0.9 * 1500.0));
}

TEST(PingClock, SpacingOnLevelGroundHasItsClosedForm) {
  const Sonar sonar;
  const double spacing = ping_spacing_m(sonar, {.spacing_m = {}, .sound_speed_mps = 1480.0}, 40.0,
                                        Angle::degrees(60), 2.5);
  EXPECT_NEAR(spacing, 2.5 * 2.0 * (40.0 / 0.5) / (0.9 * 1480.0), 1e-12);
}

TEST(PingWalker, ByTheClockEachRowsSpeedDecidesHowFarApartItsPingsLie) {
  // 0.1 s a ping; the second leg is sailed at half the speed, and the clock runs on into it.
  Route route = testing::route_through({{0, 0}, {0, 1.05}, {0, 2.0}}, kFan);
  route.waypoints[0].speed_mps = 2.0;
  route.waypoints[1].speed_mps = 1.0;
  Sonar sonar;
  sonar.max_ping_rate_hz = 10.0;
  const std::vector<Ping> pings = clock_pings(route, sonar, 1.0);
  std::vector<double> y;
  for (const Ping& ping : pings) y.push_back(ping.position.y());
  const std::vector<double> expected{0,     0.2,   0.4,   0.6,   0.8,   1.0,   1.125, 1.225,
                                     1.325, 1.425, 1.525, 1.625, 1.725, 1.825, 1.925};
  ASSERT_EQ(y.size(), expected.size());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], expected[i], 1e-9) << i;
}

TEST(PingWalker, ByTheClockAPingWithoutASoundingCountsWithTheRangeBefore) {
  const Route route = testing::route_through({{0, 0}, {0, 10}}, kFan);
  Sonar sonar;
  sonar.max_ping_rate_hz = 1000.0;
  PingWalker walker(route, sonar, {.spacing_m = {}}, {});
  std::vector<Ping> pings;
  // Route speed 2 m/s: a range of 67.5 m makes 0.1 s and 0.2 m.
  const auto first_only = [&](const Ping& ping) { return ping.position.y() > 0.0 ? 0.0 : 67.5; };
  ASSERT_TRUE(walker.next(1000, pings, first_only));
  ASSERT_EQ(pings.size(), 51U);
  EXPECT_NEAR(pings[50].position.y(), 10.0, 1e-9);
  const PingFigures figures = walker.figures();
  EXPECT_EQ(figures.intervals, 50U);
  EXPECT_EQ(figures.sound_bound, 50U);
  EXPECT_NEAR(figures.mean_spacing_m, 0.2, 1e-12);
  EXPECT_NEAR(figures.largest_spacing_m, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(figures.longest_range_m, 67.5);
}

// A stray waypoint 1,000,000 km off: ten billion pings that nothing could sound.
TEST(PingWalker, StretchesBeyondReachOfDataHaveNoPings) {
  const Route route = testing::route_through({{0, 0}, {0, 20}, {1e9, 20}, {0, 20}, {0, 0}}, kFan);
  const Sonar sonar;
  Box2 reach;
  reach.extend({-50, -50});
  reach.extend({50, 50});
  for (const std::optional<double> spacing :
       {std::optional<double>(0.1), std::optional<double>()}) {
    PingWalker walker(route, sonar, {.spacing_m = spacing}, {}, reach);
    std::vector<Ping> block;
    std::size_t pings = 0, outside = 0;
    double last = 0.0;
    while (walker.next(64, block, [](const Ping&) { return 10.0; })) {
      for (const Ping& ping : block) {
        ++pings;
        outside += ping.position.x() > 50.0;
        last = ping.position.y();
      }
    }
    EXPECT_GT(pings, 200U);
    EXPECT_LE(outside, 4U);
    EXPECT_LT(last, 1.0);  // it comes back
    EXPECT_NEAR(walker.figures().beyond_data_m, 2e9 - 100.0, 2.0);
  }
}

TEST(PingWalker, WithinReachNothingChanges) {
  const Route route = testing::route_through({{0, 0}, {0, 20}, {30, 20}}, kFan);
  const Sonar sonar;
  Box2 reach;
  reach.extend({-1, -1});
  reach.extend({31, 21});
  PingWalker walker(route, sonar, {.spacing_m = 0.1}, {}, reach);
  std::vector<Ping> pings;
  ASSERT_TRUE(walker.next(1000, pings));
  const std::vector<Ping> all = all_pings(route, 0.1);
  ASSERT_EQ(pings.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(pings[i].position, all[i].position);
  EXPECT_EQ(walker.figures().beyond_data_m, 0.0);
}

TEST(PingWalker, TheClockRunsOnThroughLegsWithTheSonarOff) {
  Route route = testing::route_through({{0, 0}, {0, 1}, {0, 2}, {0, 3}}, kFan);
  route.waypoints[1].fan.reset();
  Sonar sonar;
  sonar.max_ping_rate_hz = 1000.0;
  const std::vector<Ping> pings = clock_pings(route, sonar, 0.3 * 337.5);  // 0.3 m apart
  std::vector<double> y;
  for (const Ping& ping : pings) y.push_back(ping.position.y());
  const std::vector<double> expected{0, 0.3, 0.6, 0.9, 2.1, 2.4, 2.7, 3.0};
  ASSERT_EQ(y.size(), expected.size());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], expected[i], 1e-9) << i;
}

}  // namespace
}  // namespace swathplan

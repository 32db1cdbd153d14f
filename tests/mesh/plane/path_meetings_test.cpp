#include "mesh/plane/path_meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/plane/path_crossings.h"

namespace swathplan {
namespace {

/// The path with a point at least each `step` metres, moved by up to `noise` to either side.
std::vector<Vec2> dense(const std::vector<Vec2>& path, double step, double noise = 0.0) {
  std::mt19937 random(7);
  const auto shake = [&] { return noise * (static_cast<double>(random()) / 2147483648.0 - 1.0); };
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double steps = std::ceil((path[i + 1] - path[i]).norm() / step);
    for (double k = 0; k < steps; ++k) {
      points.push_back(path[i] + k / steps * (path[i + 1] - path[i]) + Vec2(shake(), shake()));
    }
  }
  points.push_back(path.back());
  return points;
}

TEST(PathMeetings, NoneInSimplePaths) {
  EXPECT_EQ(path_meetings({}).crossings, 0U);
  const std::vector<Vec2> round{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
  EXPECT_EQ(path_meetings(round).crossings, 0U);
  EXPECT_EQ(path_meetings(round).shared_stretches, 0U);
  EXPECT_EQ(path_meetings(dense(round, 0.1)).shared_m, 0.0);
}

TEST(PathMeetings, ACrossingCountsOnceHoweverItsPointsLie) {
  const std::vector<Vec2> eight{{0, 0}, {8, 8}, {8, 0}, {0, 8}};
  EXPECT_EQ(path_meetings(eight).crossings, 1U);
  for (const double step : {0.03, 0.1, 0.7, 1.0}) {
    EXPECT_EQ(path_meetings(dense(eight, step)).crossings, 1U) << step;
    EXPECT_EQ(path_meetings(dense(eight, step)).shared_stretches, 0U) << step;
  }
}

TEST(PathMeetings, ACornerThatReachesAcrossALineCrossesItTwice) {
  EXPECT_EQ(path_meetings({{0, 0}, {20, 0}, {20, 9}, {10, -1}, {0, 9}}).crossings, 2U);
  // One that reaches less than a hand's width beyond is a touch.
  EXPECT_EQ(path_meetings({{0, 0}, {20, 0}, {20, 9}, {10, -0.002}, {0, 9}}).crossings, 0U);
  EXPECT_EQ(path_meetings({{0, 0}, {20, 0}, {20, 9}, {10, 0}, {0, 9}}).crossings, 0U);
}

struct SharedCase {
  const char* what;
  std::vector<Vec2> path;
  std::size_t crossings;
  double shared_m;
};

TEST(PathMeetings, ASharedStretchCountsOnceAndAsACrossingOnlyIfItCrosses) {
  const SharedCase cases[] = {
      {"joins from port, leaves to port",
       {{0, 0}, {30, 0}, {30, 9}, {10, 9}, {10, 0}, {20, 0}, {20, 5}},
       0,
       10},
      {"joins from port, leaves to starboard",
       {{0, 0}, {30, 0}, {30, 9}, {10, 9}, {10, 0}, {20, 0}, {20, -5}},
       1,
       10},
      {"the other way, leaves to port",
       {{0, 0}, {30, 0}, {30, 9}, {20, 9}, {20, 0}, {10, 0}, {10, 5}},
       0,
       10},
      {"the other way, leaves to starboard",
       {{0, 0}, {30, 0}, {30, 9}, {20, 9}, {20, 0}, {10, 0}, {10, -5}},
       1,
       10},
      {"ends on it", {{0, 0}, {30, 0}, {30, 9}, {20, 9}, {20, 0}, {10, 0}}, 0, 10},
      {"turns back on itself", {{0, 0}, {30, 0}, {10, 0}, {10, 7}}, 0, 20},
  };
  for (const SharedCase& c : cases) {
    for (const double step : {100.0, 0.2}) {
      for (const double noise : {0.0, 1e-9, 1e-6, 5e-4}) {
        std::vector<Vec2> path = dense(c.path, step, noise);
        for (const bool backwards : {false, true}) {
          const PathMeetings found = path_meetings(path);
          EXPECT_EQ(found.crossings, c.crossings) << c.what << ' ' << step << ' ' << noise;
          EXPECT_EQ(found.shared_stretches, 1U) << c.what << ' ' << step << ' ' << noise;
          EXPECT_NEAR(found.shared_m, c.shared_m, 0.1) << c.what << ' ' << step << ' ' << noise;
          if (!backwards) std::reverse(path.begin(), path.end());
        }
      }
    }
  }
}

TEST(PathMeetings, NoMetreIsSharedTwice) {
  // The same 10 m for the third time.
  const std::vector<Vec2> thrice{{0, 0},  {10, 0}, {10, 5}, {0, 5}, {0, 0},
                                 {10, 0}, {10, 5}, {0, 5},  {0, 0}, {10, 0}};
  EXPECT_NEAR(path_meetings(thrice).shared_m, 40.0, 1e-6);
}

TEST(PathMeetings, ALoopCrossesOnceAndTwoRoundsShareTheSecond) {
  std::vector<Vec2> loop{{-9, 0}};
  const auto go_round = [&](int rounds) {
    for (int k = 0; k <= 120 * rounds; ++k) {
      const double a = 2 * M_PI * k / 120;
      loop.emplace_back(2.0 * std::sin(a), 2.0 - 2.0 * std::cos(a));
    }
    loop.emplace_back(9, 0);
  };
  go_round(1);
  // Comes in and leaves on a tangent, and still crosses its own way in.
  EXPECT_EQ(path_meetings(loop).crossings, 1U);
  loop = {{-9, 0.5}};
  go_round(2);
  EXPECT_NEAR(path_meetings(loop).shared_m, 4.0 * M_PI, 0.5);
  EXPECT_LE(path_meetings(loop).crossings, 2U);
}

TEST(PathMeetings, AgreeWithExactCrossingsOfRandomPaths) {
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec2> path{{1000.0 * uniform(), 0}};
    for (int i = 0; i < 300; ++i) {
      const double step = 1000.0 * (i % 17 == 0 ? 60.0 : 3.0);  // far above what is together
      path.push_back(path.back() + step * Vec2(uniform() - 0.5, uniform() - 0.5));
    }
    EXPECT_EQ(path_meetings(path).crossings, self_crossings(path)) << trial;
  }
}

}  // namespace
}  // namespace swathplan

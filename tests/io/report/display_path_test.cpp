#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "io/report/display_path_internal.h"
#include "io/sample_plan.h"

namespace swathplan {
namespace {

TEST(DisplayPath, StaysWithinTheTolerance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  std::vector<Vec2> line{Vec2::Zero()};
  for (int i = 0; i < 700; ++i) line.push_back(line.back() + Vec2(step(random), step(random)));
  for (const double tolerance : {0.0, 0.1, 0.7, 3.0}) {
    const std::vector<Vec2> kept = internal::simplified(line, tolerance);
    EXPECT_EQ(kept.front(), line.front());
    EXPECT_EQ(kept.back(), line.back());
    std::size_t segment = 0;
    for (const Vec2& p : line) {
      if (segment + 2 < kept.size() && p == kept[segment + 1]) ++segment;
      const Vec2 a = kept[segment], along = kept[segment + 1] - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      EXPECT_LE((p - a - t * along).norm(), tolerance + 1e-9);
    }
  }
}

TEST(DisplayPath, JoinsWhatLooksAlikeAndKeepsTheEnds) {
  const Route route = test::parallel_lines({.min = Vec2(0.0, 0.0), .max = Vec2(100.0, 50.0)}, 25.0);
  const std::vector<internal::DisplayPath> path = internal::display_path(route, 0.01);
  ASSERT_EQ(path.size(), legs(route).size());
  EXPECT_EQ(path.front().points.front(), route.waypoints.front().position);
  EXPECT_EQ(path.back().points.back(), route.waypoints.back().position);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_EQ(path[i].points.front(), path[i - 1].points.back());
  }
}

}  // namespace
}  // namespace swathplan

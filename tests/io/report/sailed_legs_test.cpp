#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "io/report/pen_internal.h"
#include "io/report/sailed_legs_internal.h"
#include "io/sample_plan.h"

namespace swathplan {
namespace {

TEST(Pen, SimplifiedLinesStayWithinTheTolerance) {
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

TEST(SailedLegs, HangTogetherInPlaceAndTime) {
  const Route route = test::parallel_lines({.min = Vec2(0.0, 0.0), .max = Vec2(100.0, 50.0)}, 25.0);
  const std::vector<internal::SailedLeg> sailed = internal::sailed_legs(route, 0.01, 1000);
  ASSERT_EQ(sailed.size(), legs(route).size());
  EXPECT_EQ(sailed.front().points.front(), route.waypoints.front().position);
  EXPECT_EQ(sailed.back().points.back(), route.waypoints.back().position);
  EXPECT_EQ(sailed.front().seconds.front(), 0.0);
  EXPECT_NEAR(sailed.back().seconds.back(), length_m(route) / 2.0, 1e-9);
  for (std::size_t i = 1; i < sailed.size(); ++i) {
    EXPECT_EQ(sailed[i].points.front(), sailed[i - 1].points.back());
    EXPECT_EQ(sailed[i].seconds.front(), sailed[i - 1].seconds.back());
    EXPECT_EQ(sailed[i].points.size(), sailed[i].seconds.size());
  }
}

TEST(SailedLegs, AreThinnedUntilFewPointsAreLeft) {
  Route circle;
  for (int i = 0; i <= 720; ++i) {
    const double a = i / 114.6;
    Waypoint& w = circle.waypoints.emplace_back();
    w.position = 20.0 * Vec2(std::cos(a), std::sin(a));
  }
  circle.waypoints.back().kind = LegKind::end;
  const std::size_t all = internal::sailed_legs(circle, 1e-6, 1000).front().points.size();
  const auto thinned = internal::sailed_legs(circle, 0.01, 20);
  EXPECT_EQ(all, 721U);
  EXPECT_LT(thinned.front().points.size(), 100U);
  EXPECT_NEAR(thinned.front().length_m, length_m(circle), 1e-9);  // of the leg, not of its drawing
}

}  // namespace
}  // namespace swathplan

#include "planners/steering/steer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/shapes.h"
#include "planners/steering/basin.h"

namespace swathplan {
namespace {

using test::box;

TEST(Steer, LeavesALineAsItIsWhereNothingIsTight) {
  const Connector connector(basin(100, 100), {.radius_m = 2.0});
  const std::vector<Vec2> line{{10, 10}, {50, 10}, {90, 20}};
  const Steering steering = steered(line, 2.0, connector);
  ASSERT_EQ(steering.points.size(), line.size());
  EXPECT_EQ(steering.mended, 0U);
}

TEST(Steer, RoundsASpikeAndKeepsTheRest) {
  const Connector connector(basin(100, 100), {.radius_m = 2.0});
  // Segments of one metre, so that each corner is a tight one.
  std::vector<Vec2> line;
  for (int x = 10; x <= 40; ++x) line.emplace_back(x, 50);
  for (int y = 51; y <= 80; ++y) line.emplace_back(40, y);
  const Steering steering = steered(line, 2.0, connector);
  EXPECT_EQ(steering.mended, 1U);
  EXPECT_EQ(steering.left, 0U);
  std::vector<Vec2> points;
  for (const SteeredPoint& p : steering.points) points.push_back(p.position);
  EXPECT_GE(tightest(points), 2.0 * (1.0 - 1e-6));
  EXPECT_EQ(points.front(), line.front());
  EXPECT_EQ(points.back(), line.back());
  EXPECT_LT(std::abs(steering.added_m), 2.0);
}

TEST(Steer, ACornerIsRoundedHoweverLongItsLegs) {
  const Connector connector(basin(200, 200), {.radius_m = 2.0});
  const double a = 100.0 * std::numbers::pi / 180.0;
  const Vec2 corner(100, 60);
  const std::vector<Vec2> line{{40, 60}, corner, corner + 60.0 * Vec2(std::cos(a), std::sin(a))};
  const Steering steering = steered(line, 2.0, connector);
  EXPECT_EQ(steering.mended, 1U);
  EXPECT_EQ(steering.left, 0U);
  std::vector<Vec2> points;
  for (const SteeredPoint& p : steering.points) points.push_back(p.position);
  EXPECT_GE(tightest(points), 2.0 * (1.0 - 1e-6));
}

TEST(Steer, CoincidingPointsAreOne) {
  const Connector connector(basin(100, 100), {.radius_m = 2.0});
  const std::vector<Vec2> line{{10, 10}, {10, 10}, {50, 10}, {50, 10}, {50, 10}, {90, 20}};
  const Steering steering = steered(line, 2.0, connector);
  EXPECT_EQ(steering.left, 0U);
  EXPECT_EQ(steering.points.back().position, line.back());
}

TEST(Steer, ATightTurnWithNoWayAroundItIsMarked) {
  // A corridor 3 m wide that turns a right angle; 10 m of radius do not fit.
  Area water{{Ring{{0, 0}, {40, 0}, {40, 40}, {37, 40}, {37, 3}, {0, 3}}, {}}};
  const Connector connector(water, {.radius_m = 10.0});
  const Steering steering = steered({{1, 1.5}, {38.5, 1.5}, {38.5, 39}}, 40.0, connector);
  EXPECT_EQ(steering.left, 1U);
  EXPECT_TRUE(std::any_of(steering.points.begin(), steering.points.end(),
                          [](const SteeredPoint& p) { return p.tight; }));
}

}  // namespace
}  // namespace swathplan

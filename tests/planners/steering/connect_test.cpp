#include "planners/steering/connect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/shapes.h"
#include "planners/steering/basin.h"
#include "planners/steering/steer.h"

namespace swathplan {
namespace {

using test::box;

/// In the water, no tighter than the radius, and on the lines' courses at both ends.
::testing::AssertionResult is_steerable(const Connector& connector, const Connection& way,
                                        double radius) {
  if (way.kind == JoinKind::infeasible) return ::testing::AssertionFailure() << way.reason;
  if (!connector.in_water(way.points)) return ::testing::AssertionFailure() << "leaves the water";
  if (tightest(way.points) < radius) {
    return ::testing::AssertionFailure() << "turns within " << tightest(way.points) << " m";
  }
  return ::testing::AssertionSuccess();
}

TEST(Connect, LinesUpToTheWaterEdgeAreShortenedByTheRadius) {
  const Connector connector(basin(100, 100), {.radius_m = 3.0});
  const auto way = connector.join({{30, 1}, {30, 99.95}}, {{60, 99.95}, {60, 1}});
  ASSERT_TRUE(is_steerable(connector, way, 3.0));
  EXPECT_EQ(way.kind, JoinKind::curve);
  EXPECT_NEAR(way.off_before_m, 3.0 * (1.0 + kRadiusReserve), 0.3);
  EXPECT_NEAR(way.points.front().y(), 99.95 - way.off_before_m, 1e-9);
  EXPECT_NEAR(way.points.back().y(), 99.95 - way.off_after_m, 1e-9);
}

TEST(Connect, LinesThatEndInOpenWaterAreKeptWhole) {
  const Connector connector(basin(200, 200), {.radius_m = 5.0});
  const auto way = connector.join({{80, 60}, {80, 120}}, {{100, 120}, {100, 60}});
  ASSERT_TRUE(is_steerable(connector, way, 5.0));
  EXPECT_EQ(way.off_before_m, 0.0);
  EXPECT_EQ(way.off_after_m, 0.0);
}

TEST(Connect, GoesAroundAMoleNeverAcross) {
  const Area water = subtract(basin(200, 100), {{box(98, -1, 102, 80), {}}});
  const Connector connector(water, {.radius_m = 4.0});
  const auto way = connector.join({{20, 20}, {60, 20}}, {{140, 20}, {180, 20}});
  ASSERT_TRUE(is_steerable(connector, way, 4.0));
  EXPECT_EQ(way.kind, JoinKind::way);
  const double highest =
      std::max_element(way.points.begin(), way.points.end(), [](const Vec2& a, const Vec2& b) {
        return a.y() < b.y();
      })->y();
  EXPECT_GT(highest, 80.0);
}

// The boat is as near to the next line as the wall is thin, and the way around takes 300 m. An
// estimate of some metres would fill the whole basin with poses.
TEST(Connect, GoesAroundAThinWall) {
  const Area water = subtract(basin(300, 200), {{box(149.85, -1, 150.15, 150), {}}});
  const Connector connector(water, {.radius_m = 1.5});
  const auto way = connector.join({{20, 20}, {149, 20}}, {{151, 20}, {280, 20}});
  ASSERT_TRUE(is_steerable(connector, way, 1.5));
  EXPECT_EQ(way.kind, JoinKind::way);
  const double highest =
      std::max_element(way.points.begin(), way.points.end(), [](const Vec2& a, const Vec2& b) {
        return a.y() < b.y();
      })->y();
  EXPECT_GT(highest, 150.0);
  EXPECT_LT(highest, 160.0);
}

// A no-go as thin as a cable, slanting across the water: each pair of lines that it cuts asks for a
// way around its end. Poses are counted, since time is not the same twice.
TEST(Connect, AThinNoGoTakesFewPosesAJoinAndNoneTheSecondTime) {
  const double s = 0.15 * std::sqrt(0.5);  // half of 0.3 m across, along each axis
  const Ring cable{{25 - s, 25 + s}, {25 + s, 25 - s}, {131 + s, 131 - s}, {131 - s, 131 + s}};
  const Connector connector(subtract(basin(160, 160), {{cable, {}}}), {.radius_m = 1.5});
  std::size_t joins = 0;
  for (int round = 0; round < 2; ++round) {
    const std::size_t before = connector.effort().poses;
    for (double x = 40; x < 120; x += 10) {
      // Up to the no-go from below; on from it above.
      const auto way = connector.join({{x, 1}, {x, x - 0.5}}, {{x, x + 0.5}, {x, 159}});
      ASSERT_TRUE(is_steerable(connector, way, 1.5)) << x;
      EXPECT_EQ(way.kind, JoinKind::way) << x;
      joins += round == 0 ? 1 : 0;
    }
    const std::size_t taken = connector.effort().poses - before;
    EXPECT_LT(taken, round == 0 ? 3000 * joins : 1) << round;
  }
}

// The line beyond a mole is near, but the way to it is long: an estimate across the mole leads a
// search astray in the whole basin.
TEST(Connect, FindsTheLongWayAroundAMoleFromCornersOfItsWalls) {
  const Area water = subtract(basin(260, 250), {{box(160, 100, 261, 120), {}}});
  const Connector connector(water, {.radius_m = 1.5});
  const auto way = connector.join({{240, 249}, {240, 120.1}}, {{240, 99.9}, {240, 1}});
  ASSERT_TRUE(is_steerable(connector, way, 1.5));
  double length = 0.0;
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    length += (way.points[i] - way.points[i - 1]).norm();
  }
  EXPECT_LT(length, 1.1 * (80 + 20 + 80));
}

// Four moles from alternate sides: a search over the whole way runs out of poses.
TEST(Connect, FindsALongWayAroundManyMolesInStages) {
  Area water = basin(500, 300);
  for (int k = 0; k < 4; ++k) {
    const double x = 100.0 * k + 95.0;
    water = subtract(water, {{k % 2 == 0 ? box(x, -1, x + 10, 280) : box(x, 20, x + 10, 301), {}}});
  }
  const Connector connector(water, {.radius_m = 1.5});
  const auto way = connector.join({{40, 250}, {40, 150}}, {{460, 150}, {460, 50}});
  EXPECT_TRUE(is_steerable(connector, way, 1.5));
  EXPECT_EQ(way.kind, JoinKind::way);
}

TEST(Connect, ALineToTheWallHasRoomOnlyIfATurnFitsBeforeIt) {
  const Connector connector(basin(100, 100), {.radius_m = 1.5});
  EXPECT_TRUE(connector.has_room({{50, 90}, {50, 99.9}}));
  EXPECT_FALSE(connector.has_room({{50, 98.9}, {50, 99.9}}));
  EXPECT_FALSE(connector.has_room({{50, 99.9}, {50, 98.9}}));
  EXPECT_TRUE(connector.has_room({{50, 99.9}, {52, 99.9}}));
}

TEST(Connect, AChannelNarrowerThanTwiceTheRadiusIsPassedButNotTurnedIn) {
  const Connector connector(basin(120, 8), {.radius_m = 10.0});
  const auto through = connector.join({{10, 4}, {30, 4}}, {{60, 4}, {90, 4}});
  EXPECT_TRUE(is_steerable(connector, through, 10.0));
  const auto back = connector.join({{10, 3}, {60, 3}}, {{60, 5}, {10, 5}});
  EXPECT_EQ(back.kind, JoinKind::infeasible);
  EXPECT_NE(back.reason.find("turns of 10 m"), std::string::npos) << back.reason;
  EXPECT_NE(back.reason.find("(60.0, 3.0)"), std::string::npos) << back.reason;
}

TEST(Connect, ABasinThatOnlyAReverseCouldLeaveIsInfeasible) {
  // A dead end 12 m wide off a wide water, the line running into it.
  Area water{
      {Ring{{0, 0}, {100, 0}, {100, 60}, {56, 60}, {56, 100}, {44, 100}, {44, 60}, {0, 60}}, {}}};
  const Connector connector(water, {.radius_m = 8.0});
  const auto way = connector.join({{50, 97}, {50, 99}}, {{20, 20}, {80, 20}});
  EXPECT_EQ(way.kind, JoinKind::infeasible);
  EXPECT_FALSE(way.reason.empty());
}

TEST(Connect, SeparateWatersSaySo) {
  const Connector connector({{box(0, 0, 40, 40), {}}, {box(60, 0, 100, 40), {}}},
                            {.radius_m = 2.0});
  const auto way = connector.join({{5, 20}, {30, 20}}, {{70, 20}, {95, 20}});
  EXPECT_EQ(way.kind, JoinKind::infeasible);
  EXPECT_NE(way.reason.find("no way through the water"), std::string::npos) << way.reason;
}

TEST(Connect, ReasonsNamePlacesAsTheFileDoes) {
  Frame frame;
  frame.origin = {400000, 5990000};
  const Connector connector({{box(0, 0, 40, 40), {}}, {box(60, 0, 100, 40), {}}},
                            {.radius_m = 2.0, .frame = frame});
  const auto way = connector.join({{5, 20}, {30, 20}}, {{70, 20}, {95, 20}});
  EXPECT_NE(way.reason.find("(400030.0, 5990020.0)"), std::string::npos) << way.reason;
}

TEST(Connect, ALineOfOnePointIsJoinedOnAnyCourse) {
  const Connector connector(basin(50, 50), {.radius_m = 2.0});
  const auto way = connector.join({{25, 25}}, {{10, 10}, {10, 40}});
  EXPECT_TRUE(is_steerable(connector, way, 2.0));
}

}  // namespace
}  // namespace swathplan

#include <gtest/gtest.h>

#include <vector>

#include "mesh/shapes.h"
#include "planners/steering/taut_way_internal.h"

namespace swathplan {
namespace {

using test::box_area;

TEST(TautWay, LeavesTheShorterRestOfTheWay) {
  const TautWay way({{0, 0}, {10, 0}, {10, 10}});
  EXPECT_DOUBLE_EQ(way.to_go({0, 0}), 20.0);
  EXPECT_DOUBLE_EQ(way.to_go({10, 10}), 0.0);
  // Straight to the second leg at (10, 1), and 9 m along it.
  EXPECT_DOUBLE_EQ(way.to_go({5, 1}), 5.0 + 9.0);
}

// The way leads round the end of a mole. Its last leg is near, but the mole hides it.
TEST(TautWay, DoesNotCutThroughAMole) {
  const AreaQuery water(subtract(box_area(-5, -5, 15, 25), box_area(4, -6, 6, 15)));
  const TautWay way({{0, 0}, {0, 20}, {10, 20}, {10, 0}});
  EXPECT_DOUBLE_EQ(way.to_go({2, 0}), 8.0);
  // Straight north to the second leg, 8 m along it, and the last leg.
  EXPECT_DOUBLE_EQ(way.to_go_in_sight({2, 0}, water), 20.0 + 8.0 + 20.0);
}

TEST(TautWay, StagesLieNearBothEndsOfLongStraightsOnTheirCourse) {
  std::vector<Pose> stages;
  add_stages({{0, 0}, {100, 0}}, 2.0, stages);
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].position, Vec2(10, 0));
  EXPECT_EQ(stages[1].position, Vec2(90, 0));
  for (const Pose& stage : stages) EXPECT_EQ(stage.course, Vec2(1, 0));
}

TEST(TautWay, AShortStraightHasOneStageAndAShorterOneHasNone) {
  std::vector<Pose> stages;
  add_stages({{0, 0}, {0, 10}}, 2.0, stages);
  ASSERT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].position, Vec2(0, 5));
  add_stages({{0, 0}, {0, 7.9}}, 2.0, stages);
  EXPECT_EQ(stages.size(), 1U);
}

}  // namespace
}  // namespace swathplan

#include "planners/steering/pose_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/plane/area_query.h"
#include "mesh/shapes.h"
#include "planners/steering/taut_way_internal.h"

namespace swathplan {
namespace {

using test::box_area;

PoseSearchOptions searching(const AreaQuery& water, double radius_m) {
  PoseSearchOptions options;
  options.radius_m = radius_m;
  options.place_in_water = [&water](const Vec2& p) { return water.contains(p); };
  options.in_water = [&water](const std::vector<Vec2>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double step = (points[i] - points[i - 1]).norm();
      if (water.inside_length(points[i - 1], points[i]) < step - 1e-9) return false;
    }
    return true;
  };
  return options;
}

TEST(PoseSearch, OpenWaterTakesTheDubinsPathItself) {
  const AreaQuery water(box_area(0, 0, 200, 200));
  const Pose from{{80, 80}, {1, 0}}, to{{110, 120}, {0, -1}};
  const auto options = searching(water, 4.0);
  const auto way = search_poses(
      from, to, [&](const Vec2& p) { return (to.position - p).norm(); }, options);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->size(), 2U);
  const auto path = dubins_in_water(from, to, options);
  ASSERT_TRUE(path.has_value());
  EXPECT_DOUBLE_EQ(path->length_m(), dubins_length_m(from, to, 4.0));
}

TEST(PoseSearch, GoesRoundAMoleInTheWater) {
  const AreaQuery water(subtract(box_area(0, 0, 100, 100), box_area(40, -1, 60, 70)));
  const Pose from{{20, 20}, {0, 1}}, to{{80, 20}, {0, -1}};
  const auto options = searching(water, 4.0);
  EXPECT_FALSE(dubins_in_water(from, to, options).has_value());
  const TautWay taut({{20, 20}, {40, 70}, {60, 70}, {80, 20}});
  const auto way = search_poses(
      from, to, [&](const Vec2& p) { return taut.to_go_in_sight(p, water); }, options);
  ASSERT_TRUE(way.has_value());
  EXPECT_EQ(way->front().position, from.position);
  EXPECT_EQ(way->back().position, to.position);
  double length = 0.0;
  for (std::size_t i = 1; i < way->size(); ++i) {
    const auto path = dubins_in_water((*way)[i - 1], (*way)[i], options);
    ASSERT_TRUE(path.has_value()) << "piece " << i << " leaves the water";
    length += path->length_m();
  }
  const double shortest = 2.0 * std::hypot(20.0, 50.0) + 20.0;
  EXPECT_GE(length, shortest - 1e-6);
  EXPECT_LE(length, 1.2 * shortest);
}

TEST(PoseSearch, SeparateWatersGiveUp) {
  const AreaQuery water(unite(box_area(0, 0, 30, 30), box_area(40, 0, 70, 30)));
  auto options = searching(water, 3.0);
  options.most_poses = 300;
  const Pose from{{10, 10}, {0, 1}}, to{{60, 10}, {0, 1}};
  EXPECT_FALSE(search_poses(
                   from, to, [&](const Vec2& p) { return (to.position - p).norm(); }, options)
                   .has_value());
}

TEST(PoseSearch, CurvesAreWrittenByAngleWhereTheyAreSmallAndByLengthWhereTheyAreLarge) {
  EXPECT_DOUBLE_EQ(curve_step_m(1.0), Angle::degrees(kCurveStepDeg).rad());
  EXPECT_DOUBLE_EQ(curve_step_m(100.0), kCurveStepM);
}

}  // namespace
}  // namespace swathplan

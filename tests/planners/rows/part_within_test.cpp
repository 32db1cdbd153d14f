#include "planners/rows/part_within.h"

#include <gtest/gtest.h>

#include <cmath>

namespace swathplan {
namespace {

/// Rows of these lengths, 10 m apart, joined by straight turns; 2 m/s on lines, 1 m/s in turns.
Route rows(const std::vector<double>& lengths) {
  Route route;
  double y = 0.0;
  for (std::size_t k = 0; k < lengths.size(); ++k, y += 10.0) {
    Waypoint w;
    w.position = {0.0, y};
    w.line = static_cast<int>(k) + 1;
    w.speed_mps = 2.0;
    route.waypoints.push_back(w);
    w.position.x() = lengths[k];
    w.kind = LegKind::turn;
    w.log = false;
    w.line.reset();
    w.speed_mps = 1.0;
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

TEST(PartWithin, TakesTheLinesInARowThatHaveTheMostLine) {
  const Route route = rows({50, 100, 100, 100, 50});
  const double three = 300.0 + 2.0 * std::hypot(100.0, 10.0);
  const auto part =
      part_within(route, {.coverage_pct = {}, .length_m = three + 1.0, .time_s = {}}, 20.0);
  ASSERT_TRUE(part);
  EXPECT_EQ(fault(*part), std::nullopt);
  ASSERT_EQ(part->waypoints.size(), 6U);
  EXPECT_EQ(part->waypoints.front().position, Vec2(0, 10));
  EXPECT_EQ(part->waypoints.back().position, Vec2(100, 30));
  EXPECT_EQ(part->waypoints.front().line, 1);
  EXPECT_EQ(part->waypoints[4].line, 3);
  EXPECT_NEAR(length_m(*part), three, 1e-9);
}

TEST(PartWithin, CutsALineWhereNotOneFits) {
  const Route route = rows({50, 200, 100});
  const auto part = part_within(route, {.coverage_pct = {}, .length_m = 40.0, .time_s = {}}, 20.0);
  ASSERT_TRUE(part);
  EXPECT_NEAR(length_m(*part), 40.0, 1e-6);
  EXPECT_LE(length_m(*part), 40.0);
  EXPECT_EQ(part->waypoints.front().position, Vec2(0, 10));
  EXPECT_FALSE(part_within(route, {.coverage_pct = {}, .length_m = 15.0, .time_s = {}}, 20.0));
}

TEST(PartWithin, CountsTimeAtTheSpeedOfEachLeg) {
  const Route route = rows({100, 100});
  const double join_s = std::hypot(100.0, 10.0);
  const auto both = part_within(
      route, {.coverage_pct = {}, .length_m = {}, .time_s = 100.0 + join_s + 0.1}, 20.0);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->waypoints.size(), 4U);
  const auto one =
      part_within(route, {.coverage_pct = {}, .length_m = {}, .time_s = 99.0 + join_s}, 20.0);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->waypoints.size(), 2U);
}

TEST(PartWithin, IsNothingWithoutALimitOrALine) {
  EXPECT_FALSE(part_within(rows({100, 100}), {}, 20.0));
  EXPECT_FALSE(part_within({}, {.coverage_pct = {}, .length_m = 100.0, .time_s = {}}, 20.0));
}

}  // namespace
}  // namespace swathplan

#include "planners/smoothing/join_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "planners/smoothing/join_problem_internal.h"
#include "planners/steering/basin.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

constexpr double kJoinRadius = 2.0;

/// A line's last metres, the join and the next line's first ones.
std::vector<Vec2> sailed(const std::vector<Vec2>& before, const Connection& way,
                         const std::vector<Vec2>& after) {
  const Vec2 in = (before[1] - before[0]).normalized();
  const Vec2 out = (after[1] - after[0]).normalized();
  std::vector<Vec2> path{way.points.front() - kJoinRadius * in};
  path.insert(path.end(), way.points.begin(), way.points.end());
  path.push_back(way.points.back() + kJoinRadius * out);
  return path;
}

/// From a line's end on its course, no tighter than the radius, in the water, and smoother than
/// the Connector's.
::testing::AssertionResult is_smoothed(const Connector& connector, const Connection& way,
                                       const std::vector<Vec2>& before,
                                       const std::vector<Vec2>& after) {
  const Vec2 in = (before[1] - before[0]).normalized();
  const Vec2 out = (after[1] - after[0]).normalized();
  const Vec2 from = before[1] - way.off_before_m * in;
  const Vec2 to = after[0] + way.off_after_m * out;
  if ((way.points.front() - from).norm() > 1e-9 || (way.points.back() - to).norm() > 1e-9) {
    return ::testing::AssertionFailure() << "the ends moved";
  }
  const auto path = sailed(before, way, after);
  if (tightest(path) < kJoinRadius) return ::testing::AssertionFailure() << tightest(path) << " m";
  if (!connector.in_water(way.points)) return ::testing::AssertionFailure() << "leaves the water";
  const double now = sharpest_change(path, kJoinStep * kJoinRadius);
  const double then = sharpest_change(sailed(before, connector.join(before, after), after),
                                      kJoinStep * kJoinRadius);
  if (now > 0.7 * then) return ::testing::AssertionFailure() << now << " after " << then;
  return ::testing::AssertionSuccess();
}

TEST(SharpestChange, OfALineIntoAnArcIsTheJumpOverAStepOrTwo) {
  std::vector<Vec2> path{{-10, 0}};
  for (int k = 0; k <= 90; ++k) {
    const double a = std::numbers::pi / 180.0 * k;
    path.emplace_back(5.0 * std::sin(a), 5.0 * (1.0 - std::cos(a)));
  }
  EXPECT_GT(sharpest_change(path, 0.5), 0.5 * (1.0 / 5.0) / 0.5);
  EXPECT_LT(sharpest_change(path, 0.5), 1.1 * (1.0 / 5.0) / 0.5);
  EXPECT_EQ(sharpest_change({{1, 1}}, 0.5), 0.0);
  EXPECT_NEAR(sharpest_change({{0, 0}, {9, 9}}, 0.5), 0.0, 1e-9);
}

TEST(JoinSmoothing, ATurnAtTheWaterEdgeKeepsEndsCoursesRadiusAndWater) {
  const Area water = basin(100, 100);
  const Connector connector(water, {.radius_m = kJoinRadius});
  JoinSmoother smoother(water, connector, kJoinRadius);
  const std::vector<Vec2> before{{40, 5}, {40, 99.95}}, after{{60, 99.95}, {60, 5}};
  const Connection way = smoother.join(before, after);
  EXPECT_TRUE(is_smoothed(connector, way, before, after));
  EXPECT_LT(way.off_before_m, 1.6 * kJoinRadius);
  EXPECT_EQ(smoother.tally().whole, 1U);
  EXPECT_EQ(note(smoother.tally()).rfind("smoothing: 1 of 1 joins smoothed;", 0), 0U);
}

TEST(JoinSmoothing, AnyTwoLinesInOpenWaterKeepTheirEndsCoursesAndRadius) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(60.0, 140.0), course(0.0, 2.0 * std::numbers::pi);
  const Area water = basin(200, 200);
  const Connector connector(water, {.radius_m = kJoinRadius});
  JoinSmoother smoother(water, connector, kJoinRadius);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const double a = course(random), b = course(random);
    const Vec2 p(place(random), place(random)), q(place(random), place(random));
    const std::vector<Vec2> before{p - 30.0 * Vec2(std::cos(a), std::sin(a)), p};
    const std::vector<Vec2> after{q, q + 30.0 * Vec2(std::cos(b), std::sin(b))};
    const std::size_t whole = smoother.tally().whole;
    const Connection way = smoother.join(before, after);
    if (smoother.tally().whole > whole) {
      EXPECT_TRUE(is_smoothed(connector, way, before, after));
    }
  }
  EXPECT_GE(smoother.tally().whole, 18U);
}

TEST(JoinSmoothing, WhatHasNoRoomKeepsItsArcsAndIsCounted) {
  // The turn just fits into the basin between its walls.
  const Area water = basin(2.0 * kJoinRadius * 1.03 + 0.02, 60);
  const double left = 0.01, right = 2.0 * kJoinRadius * 1.03 + 0.01;
  const Connector connector(water, {.radius_m = kJoinRadius});
  JoinSmoother smoother(water, connector, kJoinRadius);
  const std::vector<Vec2> before{{left, 5}, {left, 40}}, after{{right, 40}, {right, 5}};
  const Connection plain = connector.join(before, after);
  ASSERT_NE(plain.kind, JoinKind::infeasible);
  const Connection way = smoother.join(before, after);
  EXPECT_EQ(smoother.tally().joins, 1U);
  EXPECT_EQ(smoother.tally().whole, 0U);
  EXPECT_EQ(smoother.tally().kept.size(), 1U);
  EXPECT_GE(tightest(sailed(before, way, after)), kJoinRadius);
  EXPECT_TRUE(connector.in_water(way.points));
  EXPECT_NE(note(smoother.tally()).find("bends keep their arcs"), std::string::npos);
}

TEST(JoinSmoothing, AStraightJoinIsLeftAloneAndNotCounted) {
  const Area water = basin(100, 100);
  const Connector connector(water, {.radius_m = kJoinRadius});
  JoinSmoother smoother(water, connector, kJoinRadius);
  const Connection way = smoother.join({{10, 50}, {30, 50}}, {{60, 50}, {90, 50}});
  EXPECT_NEAR(LinePoses(way.points).length_m(), 30.0, 1e-9);
  EXPECT_EQ(smoother.tally().joins, 0U);
}

TEST(JoinProblem, NearAnEdgeItHasAHalfPlaneThatTheStartKeeps) {
  const Area area = basin(100, 100);
  const AreaQuery water(area);
  const LinePoses line({{40, 98}, {60, 98}});
  const JoinProblem problem({{40, 98}, {1, 0}}, {{60, 98}, {1, 0}}, sampled(line, 0.25), 2.0,
                            water);
  const PathProblem stated = problem.stated();
  ASSERT_FALSE(stated.half_planes.empty());
  for (const HalfPlane& side : stated.half_planes) {
    const Vec2& p = stated.start[static_cast<std::size_t>(side.point)];
    EXPECT_LT(side.normal.dot(p), side.upper);
    EXPECT_GT(side.normal.dot(p + Vec2(0, 2.0 / 0.25)), side.upper);
  }
}

SmoothedCurve curve_with(std::size_t smoothed, std::size_t bends) {
  SmoothedCurve curve;
  curve.smoothed = smoothed;
  curve.bends = bends;
  return curve;
}

TEST(JoinSmoother, KeepsTheCandidateOfWhichMostIsSmoothed) {
  EXPECT_TRUE(takes_over(curve_with(2, 2), curve_with(1, 2)));
  EXPECT_FALSE(takes_over(curve_with(1, 2), curve_with(1, 2))) << "of equals the wider one stays";
  EXPECT_FALSE(takes_over(curve_with(1, 3), curve_with(1, 2)));
  EXPECT_FALSE(takes_over(curve_with(0, 2), curve_with(1, 2))) << "a smoothed bend is not given up";
  EXPECT_TRUE(takes_over(curve_with(0, 2), curve_with(0, 2))) << "with none the plain join stays";
}

}  // namespace
}  // namespace swathplan

#include <gtest/gtest.h>

#include "planners/smoothing/path_solver_internal.h"

namespace swathplan {
namespace {

/// One point that may move within +-5 m and is drawn to (3, 1).
PathProblem drawn_point() {
  PathProblem problem;
  problem.start = {{0, 0}};
  problem.low = {Vec2::Constant(-5.0)};
  problem.high = {Vec2::Constant(5.0)};
  problem.terms = {{{{0, 1.0}}, 3.0, 1.0}, {{{1, 1.0}}, 1.0, 1.0}};
  return problem;
}

TEST(PathSolver, FindsTheLeastOfASumOfSquares) {
  const PathSolution found = solved_by_ipopt(drawn_point(), 100);
  ASSERT_TRUE(found.good) << found.status;
  EXPECT_EQ(found.status, "solved");
  EXPECT_NEAR((found.points[0] - Vec2(3, 1)).norm(), 0.0, 1e-3);
}

TEST(PathSolver, StopsAtTheBoxTheEdgeAndTheNorm) {
  PathProblem boxed = drawn_point();
  boxed.high[0].x() = 2.0;
  EXPECT_NEAR((solved_by_ipopt(boxed, 100).points[0] - Vec2(2, 1)).norm(), 0.0, 0.02);

  PathProblem edged = drawn_point();
  edged.half_planes = {{0, Vec2(1, 0), 1.0}};
  EXPECT_NEAR((solved_by_ipopt(edged, 100).points[0] - Vec2(1, 1)).norm(), 0.0, 0.02);

  // The nearest point to (3, 1) within a circle lies on the ray to it.
  PathProblem ringed = drawn_point();
  ringed.norms = {{{{0, 1.0}}, 0.0, 4.0}};
  EXPECT_NEAR((solved_by_ipopt(ringed, 100).points[0] - 2.0 * Vec2(3, 1).normalized()).norm(), 0.0,
              0.02);
}

TEST(PathSolver, AProblemWithoutASolutionIsNotGood) {
  PathProblem problem = drawn_point();
  problem.half_planes = {{0, Vec2(1, 0), -1.0}, {0, Vec2(-1, 0), -1.0}};  // x <= -1 and x >= 1
  const PathSolution found = solved_by_ipopt(problem, 100);
  EXPECT_FALSE(found.good);
  EXPECT_NE(found.status, "solved");
}

TEST(PathSolver, AtTheIterationLimitOnlyBrokenBoundsCount) {
  PathProblem problem = drawn_point();
  problem.half_planes = {{0, Vec2(1, 0), 2.5}};
  const PathSolution kept = solved_by_ipopt(problem, 0);
  EXPECT_EQ(kept.status, "iteration limit");
  EXPECT_TRUE(kept.good);
  problem.half_planes = {{0, Vec2(1, 0), -4.0}};
  const PathSolution broken = solved_by_ipopt(problem, 0);
  EXPECT_EQ(broken.status, "iteration limit");
  EXPECT_FALSE(broken.good);
}

TEST(PathSolver, GivesTheSameBytesAgain) {
  const PathProblem problem = drawn_point();
  EXPECT_EQ(solved_by_ipopt(problem, 100).points[0], solved_by_ipopt(problem, 100).points[0]);
}

}  // namespace
}  // namespace swathplan

#include "planners/smoothing/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/base/error.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

std::vector<Vec2> staircase(int steps) {
  std::vector<Vec2> path{{0, 0}};
  for (int i = 0; i < steps; ++i) {
    path.push_back(path.back() + (i % 2 == 0 ? Vec2(8, 0) : Vec2(0, 8)));
  }
  return path;
}

double course_change(const std::vector<Vec2>& p) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec2 a = p[i] - p[i - 1];
    const Vec2 b = p[i + 1] - p[i];
    sum += std::pow(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)), 2);
  }
  return sum;
}

TEST(Smooth, EndsStayPointsKeepTheirBoundAndThePathGetsSmoother) {
  SmoothOptions options{.radius_m = 1.5, .step_m = 1.6, .deviation_m = 1.0};
  const auto skeleton = staircase(20);
  const SmoothResult result = smooth_path(skeleton, options);
  EXPECT_EQ(result.failed_windows, 0U);
  EXPECT_LT((result.points.front() - skeleton.front()).norm(), 1e-9);
  EXPECT_LT((result.points.back() - skeleton.back()).norm(), 1e-9);
  options.deviation_m = 0.0;
  const SmoothResult still = smooth_path(skeleton, options);
  ASSERT_EQ(still.points.size(), result.points.size());
  for (std::size_t i = 0; i < still.points.size(); ++i) {
    EXPECT_LE((result.points[i] - still.points[i]).norm(), 1.0 + 1e-6);
  }
  EXPECT_LT(course_change(result.points), 0.5 * course_change(still.points));
}

TEST(Smooth, NoPointMovesFartherThanItsRoom) {
  SmoothOptions options{.step_m = 1.6, .deviation_m = 2.0};
  options.room = [](const Vec2&, const Vec2&) { return 0.2; };
  const SmoothResult result = smooth_path(staircase(12), options);
  options.deviation_m = 0.0;
  const SmoothResult still = smooth_path(staircase(12), options);
  for (std::size_t i = 0; i < still.points.size(); ++i) {
    EXPECT_LE((result.points[i] - still.points[i]).norm(), 0.2 + 1e-6);
  }
}

TEST(Smooth, AStraightPathStaysStraight) {
  const SmoothResult result = smooth_path({{0, 0}, {60, 0}}, {});
  for (const Vec2& p : result.points) EXPECT_NEAR(p.y(), 0.0, 1e-6);
}

TEST(Smooth, PointsGoWhereTheyArePulledWithinTheirBound) {
  SmoothOptions options{.deviation_m = 1.5, .pull_rounds = 6};
  int asked = 0;
  options.pull = [&](std::vector<Vec2> points, const std::vector<double>& along) {
    EXPECT_EQ(points.size(), along.size());
    for (Vec2& p : points) p.y() += 0.5;
    ++asked;
    return points;
  };
  const SmoothResult result = smooth_path({{0, 0}, {60, 0}}, options);
  EXPECT_EQ(asked, 6);
  EXPECT_EQ(result.failed_windows, 0U);
  EXPECT_NEAR(result.points.front().y(), 0.0, 1e-9);
  EXPECT_NEAR(result.points.back().y(), 0.0, 1e-9);
  const double middle = result.points[result.points.size() / 2].y();
  EXPECT_GT(middle, 0.8);
  EXPECT_LT(middle, 1.5);
}

TEST(Smooth, PassesDoNotMeet) {
  // Two passes 2 m apart, each pulled towards the other.
  const std::vector<Vec2> skeleton{{0, 0}, {60, 0}, {60, 2}, {0, 2}};
  SmoothOptions options{.deviation_m = 3.0};
  options.pull = [](std::vector<Vec2> points, const std::vector<double>& along) {
    for (std::size_t i = 0; i < points.size(); ++i) points[i].y() += along[i] < 61.0 ? 1.0 : -1.0;
    return points;
  };
  const SmoothResult result = smooth_path(skeleton, options);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (result.along[i] < 50.0) {
      EXPECT_LT(result.points[i].y(), 1.0);
    } else if (result.along[i] > 72.0) {
      EXPECT_GT(result.points[i].y(), 1.0);
    }
  }
}

TEST(Smooth, DegeneratePathsComeBackAsTheyAre) {
  EXPECT_EQ(smooth_path({{1, 2}}, {}).points.size(), 1U);
  EXPECT_EQ(smooth_path({{1, 2}, {1, 2}, {1, 2}}, {}).points.size(), 1U);
  EXPECT_EQ(smooth_path({{0, 0}, {1, 0}, {1, 1}}, {.step_m = 1.6}).points.size(), 3U);
}

TEST(Smooth, AClosedLoopIsSmoothedBetweenItsEnds) {
  const std::vector<Vec2> loop{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}};
  const SmoothResult result = smooth_path(loop, {.deviation_m = 1.0});
  EXPECT_EQ(result.failed_windows, 0U);
  EXPECT_LT((result.points.back() - loop.back()).norm(), 1e-9);
}

TEST(Smooth, WindowsTogetherCoverALongPathTheSameEachTime) {
  const SmoothOptions options{.window = 40, .overlap = 10};
  const SmoothResult once = smooth_path(staircase(40), options);
  const SmoothResult again = smooth_path(staircase(40), options);
  EXPECT_GT(once.windows, 5U);
  EXPECT_EQ(once.points, again.points);
}

TEST(Smooth, EveryWindowIsSolvedBeforeTheIterationLimit) {
  const SmoothResult result = smooth_path(staircase(60), {});
  EXPECT_GT(result.windows, 1U);
  EXPECT_EQ(result.status, (std::map<std::string, std::size_t>{{"solved", result.windows}}));
  EXPECT_EQ(result.failed_m, 0.0);
}

TEST(Smooth, RefusesOptionsOutOfRange) {
  EXPECT_THROW(static_cast<void>(smooth_path({{0, 0}, {9, 0}}, {.step_m = 0.0})), UsageError);
  EXPECT_THROW(static_cast<void>(smooth_path({{0, 0}, {9, 0}}, {.radius_m = -1.0})), UsageError);
}

TEST(WithArcs, ArcsHaveTheRadiusOfTheCorner) {
  const ArcPath path = with_arcs({{0, 0}, {10, 0}, {10, 10}});
  const LinePoses line(path.points);
  for (std::size_t i = 2; i + 2 < line.points().size(); ++i) {
    EXPECT_NEAR(line.radius_at(i, 5.0), 5.0, 0.02);
  }
}

}  // namespace
}  // namespace swathplan

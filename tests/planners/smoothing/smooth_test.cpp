#include "planners/smoothing/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/base/error.h"
#include "planners/smoothing/path_nlp_internal.h"
#include "planners/smoothing/path_relaxation_internal.h"
#include "planners/steering/line_poses.h"

namespace swathplan {
namespace {

/// A problem with every kind of term over random points.
PathProblem sample_problem() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  PathProblem problem;
  for (int i = 0; i < 6; ++i) {
    problem.start.emplace_back(any(random), any(random));
    problem.low.push_back(Vec2::Constant(-5.0));
    problem.high.push_back(Vec2::Constant(5.0));
  }
  problem.terms = {{{{0, -1.0}, {2, 3.0}, {4, -3.0}, {6, 1.0}}, 0.3, 2.0},
                   {{{5, 1.0}}, -0.7, 0.5},
                   {{{1, 0.6}, {0, 0.8}, {10, -0.8}, {11, -0.6}}, 1.5, 0.1}};
  problem.norms = {{{{0, 1.0}, {1, -2.0}, {2, 1.0}}, 0.0, 4.0}, {{{4, -1.0}, {5, 1.0}}, 0.5, 2.0}};
  problem.half_planes = {{3, {0.6, -0.8}, 0.4}};
  return problem;
}

struct Shape {
  Ipopt::Index n = 0, m = 0, jac = 0, hess = 0;
  explicit Shape(PathNlp& nlp) {
    Ipopt::TNLP::IndexStyleEnum style{};
    nlp.get_nlp_info(n, m, jac, hess, style);
  }
};

std::vector<double> flat(const PathProblem& problem) {
  std::vector<double> x;
  for (const Vec2& p : problem.start) {
    x.push_back(p.x());
    x.push_back(p.y());
  }
  return x;
}

std::vector<double> gradient(PathNlp& nlp, const std::vector<double>& x) {
  std::vector<double> g(x.size());
  nlp.eval_grad_f(static_cast<int>(x.size()), x.data(), true, g.data());
  return g;
}

Eigen::MatrixXd jacobian(PathNlp& nlp, const Shape& shape, const std::vector<double>& x) {
  std::vector<int> row(static_cast<std::size_t>(shape.jac)), column(row);
  std::vector<double> value(row.size());
  nlp.eval_jac_g(shape.n, nullptr, true, shape.m, shape.jac, row.data(), column.data(), nullptr);
  nlp.eval_jac_g(shape.n, x.data(), true, shape.m, shape.jac, nullptr, nullptr, value.data());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(shape.m, shape.n);
  for (std::size_t k = 0; k < value.size(); ++k) full(row[k], column[k]) += value[k];
  return full;
}

constexpr double kStep = 1e-6;

TEST(PathNlp, GradientMatchesFiniteDifferences) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  std::vector<double> x = flat(problem);
  const auto exact = gradient(nlp, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    double above = 0.0, below = 0.0;
    x[i] += kStep;
    nlp.eval_f(static_cast<int>(x.size()), x.data(), true, above);
    x[i] -= 2.0 * kStep;
    nlp.eval_f(static_cast<int>(x.size()), x.data(), true, below);
    x[i] += kStep;
    EXPECT_NEAR(exact[i], (above - below) / (2.0 * kStep), 1e-6);
  }
}

TEST(PathNlp, JacobianMatchesFiniteDifferences) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  const Shape shape(nlp);
  std::vector<double> x = flat(problem);
  const Eigen::MatrixXd exact = jacobian(nlp, shape, x);
  for (int i = 0; i < shape.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    std::vector<double> above(3), below(3);
    x[k] += kStep;
    nlp.eval_g(shape.n, x.data(), true, shape.m, above.data());
    x[k] -= 2.0 * kStep;
    nlp.eval_g(shape.n, x.data(), true, shape.m, below.data());
    x[k] += kStep;
    for (int c = 0; c < shape.m; ++c) {
      const auto j = static_cast<std::size_t>(c);
      EXPECT_NEAR(exact(c, i), (above[j] - below[j]) / (2.0 * kStep), 1e-6);
    }
  }
}

TEST(PathNlp, HessianMatchesFiniteDifferencesOfTheLagrangian) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  const Shape shape(nlp);
  std::vector<double> x = flat(problem);
  const double factor = 0.7;
  const Eigen::Vector3d lambda(1.3, -0.4, 0.9);
  std::vector<int> row(static_cast<std::size_t>(shape.hess)), column(row);
  std::vector<double> value(row.size());
  nlp.eval_h(shape.n, nullptr, true, factor, shape.m, nullptr, true, shape.hess, row.data(),
             column.data(), nullptr);
  nlp.eval_h(shape.n, x.data(), true, factor, shape.m, lambda.data(), true, shape.hess, nullptr,
             nullptr, value.data());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(shape.n, shape.n);
  for (std::size_t k = 0; k < value.size(); ++k) {
    ASSERT_GE(row[k], column[k]);
    full(row[k], column[k]) += value[k];
    if (row[k] != column[k]) full(column[k], row[k]) += value[k];
  }
  const auto slope = [&](const std::vector<double>& at) {
    const auto g = gradient(nlp, at);
    const Eigen::VectorXd bound = jacobian(nlp, shape, at).transpose() * lambda;
    Eigen::VectorXd sum(shape.n);
    for (int i = 0; i < shape.n; ++i) sum(i) = factor * g[static_cast<std::size_t>(i)] + bound(i);
    return sum;
  };
  for (int i = 0; i < shape.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    x[k] += kStep;
    const Eigen::VectorXd above = slope(x);
    x[k] -= 2.0 * kStep;
    const Eigen::VectorXd below = slope(x);
    x[k] += kStep;
    const Eigen::VectorXd expected = (above - below) / (2.0 * kStep);
    for (int j = 0; j < shape.n; ++j) EXPECT_NEAR(full(j, i), expected(j), 1e-5);
  }
}

TEST(PathNlp, ANormIsBoundedBelowOnlyByMoreThanZero) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  std::vector<double> x_low(12), x_high(12), low(3), high(3);
  nlp.get_bounds_info(12, x_low.data(), x_high.data(), 3, low.data(), high.data());
  EXPECT_LT(low[0], -1e19);  // Ipopt's infinity: 0 would be a barrier that bends straight stretches
  EXPECT_EQ(low[1], 0.5);
  EXPECT_EQ(high[0], 4.0);
  EXPECT_LT(low[2], -1e19);
  EXPECT_EQ(high[2], 0.4);
}

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
  const SmoothResult result = smooth_path({{0, 0}, {60, 0}}, {.width_m = 1.0});
  for (const Vec2& p : result.points) EXPECT_NEAR(p.y(), 0.0, 1e-6);
}

TEST(Smooth, PassesMoveApart) {
  // Three passes 10, then 6 m apart: the middle one is drawn towards the middle.
  const std::vector<Vec2> skeleton{{0, 0}, {60, 0}, {60, 10}, {0, 10}, {0, 16}, {60, 16}};
  const SmoothOptions options{.width_m = 25.6, .deviation_weight = 0.002, .spacing_weight = 0.1};
  const SmoothResult result = smooth_path(skeleton, options);
  double middle = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (result.along[i] < 85.0 || result.along[i] > 115.0) continue;
    middle += result.points[i].y();
    ++count;
  }
  EXPECT_LT(middle / count, 9.7);
}

TEST(Smooth, PointsGoWhereTheyArePulledWithinTheirBound) {
  SmoothOptions options{.deviation_m = 1.5, .spacing_weight = 0.0, .pull_rounds = 6};
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
  SmoothOptions options{.deviation_m = 3.0, .spacing_weight = 0.0};
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

TEST(PathRelaxation, KeepsStraightLinesAndEndsAndClamps) {
  const std::vector<Vec2> line{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
  const PathRelaxation relaxation(line.size(), 3.0, 0.2);
  const std::vector<double> room(line.size(), 0.25);
  const auto same = relaxation.relaxed(line, line, room);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_LT((same[i] - line[i]).norm(), 1e-6);
  auto wanted = line;
  for (Vec2& p : wanted) p.y() += 2.0;
  const auto moved = relaxation.relaxed(wanted, line, room);
  EXPECT_EQ(moved.front(), line.front());
  EXPECT_EQ(moved[2].y(), 0.25);
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
    EXPECT_NEAR(line.radius_at(i), 5.0, 0.02);
  }
}

}  // namespace
}  // namespace swathplan

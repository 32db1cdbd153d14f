#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "planners/smoothing/path_nlp_internal.h"

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

std::vector<double> flattened(const PathProblem& problem) {
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

constexpr double kDifferenceStep = 1e-6;

TEST(PathNlp, GradientMatchesFiniteDifferences) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  std::vector<double> x = flattened(problem);
  const auto exact = gradient(nlp, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    double above = 0.0, below = 0.0;
    x[i] += kDifferenceStep;
    nlp.eval_f(static_cast<int>(x.size()), x.data(), true, above);
    x[i] -= 2.0 * kDifferenceStep;
    nlp.eval_f(static_cast<int>(x.size()), x.data(), true, below);
    x[i] += kDifferenceStep;
    EXPECT_NEAR(exact[i], (above - below) / (2.0 * kDifferenceStep), 1e-6);
  }
}

TEST(PathNlp, JacobianMatchesFiniteDifferences) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  const Shape shape(nlp);
  std::vector<double> x = flattened(problem);
  const Eigen::MatrixXd exact = jacobian(nlp, shape, x);
  for (int i = 0; i < shape.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    std::vector<double> above(3), below(3);
    x[k] += kDifferenceStep;
    nlp.eval_g(shape.n, x.data(), true, shape.m, above.data());
    x[k] -= 2.0 * kDifferenceStep;
    nlp.eval_g(shape.n, x.data(), true, shape.m, below.data());
    x[k] += kDifferenceStep;
    for (int c = 0; c < shape.m; ++c) {
      const auto j = static_cast<std::size_t>(c);
      EXPECT_NEAR(exact(c, i), (above[j] - below[j]) / (2.0 * kDifferenceStep), 1e-6);
    }
  }
}

TEST(PathNlp, HessianMatchesFiniteDifferencesOfTheLagrangian) {
  const PathProblem problem = sample_problem();
  PathNlp nlp(problem);
  const Shape shape(nlp);
  std::vector<double> x = flattened(problem);
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
    x[k] += kDifferenceStep;
    const Eigen::VectorXd above = slope(x);
    x[k] -= 2.0 * kDifferenceStep;
    const Eigen::VectorXd below = slope(x);
    x[k] += kDifferenceStep;
    const Eigen::VectorXd expected = (above - below) / (2.0 * kDifferenceStep);
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

}  // namespace
}  // namespace swathplan

#pragma once

#include <IpTNLP.hpp>
#include <utility>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// 1/2 weight (sum of coefficient x variable - target)^2. Variable 2i is x, 2i + 1 is y of point i.
struct LinearTerm {
  std::vector<std::pair<int, double>> parts;
  double target = 0.0;
  double weight = 1.0;
};

/// lower <= |sum of coefficient x point|^2 <= upper; a `lower` of 0 is no bound.
struct NormConstraint {
  std::vector<std::pair<int, double>> parts;  ///< point, coefficient
  double lower = 0.0, upper = 0.0;
};

/// normal . point <= upper: the point stays on one side of a straight edge.
struct HalfPlane {
  int point = 0;
  Vec2 normal = Vec2::UnitX();
  double upper = 0.0;
};

/// Points to be found: sums of squares of linear terms, boxes, norms of differences, and
/// half-planes (constraints in this order). All second derivatives are constant.
struct PathProblem {
  std::vector<Vec2> start, low, high;  ///< one for each point; low = high fixes the point
  std::vector<LinearTerm> terms;
  std::vector<NormConstraint> norms;
  std::vector<HalfPlane> half_planes;
};

/// The problem for Ipopt, with exact sparse derivatives.
class PathNlp : public Ipopt::TNLP {
 public:
  explicit PathNlp(const PathProblem& problem) : problem_(problem) {}
  [[nodiscard]] const std::vector<Vec2>& points() const { return points_; }

  // clang-format off
  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& nnz_jac, Ipopt::Index& nnz_hess, IndexStyleEnum& style) override;
  bool get_bounds_info(Ipopt::Index n, Ipopt::Number* x_l, Ipopt::Number* x_u, Ipopt::Index m, Ipopt::Number* g_l, Ipopt::Number* g_u) override;
  bool get_starting_point(Ipopt::Index n, bool init_x, Ipopt::Number* x, bool init_z, Ipopt::Number* z_l, Ipopt::Number* z_u, Ipopt::Index m, bool init_lambda, Ipopt::Number* lambda) override;
  bool eval_f(Ipopt::Index n, const Ipopt::Number* x, bool fresh, Ipopt::Number& value) override;
  bool eval_grad_f(Ipopt::Index n, const Ipopt::Number* x, bool fresh, Ipopt::Number* gradient) override;
  bool eval_g(Ipopt::Index n, const Ipopt::Number* x, bool fresh, Ipopt::Index m, Ipopt::Number* g) override;
  bool eval_jac_g(Ipopt::Index n, const Ipopt::Number* x, bool fresh, Ipopt::Index m, Ipopt::Index count, Ipopt::Index* row, Ipopt::Index* column, Ipopt::Number* values) override;
  bool eval_h(Ipopt::Index n, const Ipopt::Number* x, bool fresh, Ipopt::Number factor, Ipopt::Index m, const Ipopt::Number* lambda, bool fresh_lambda, Ipopt::Index count, Ipopt::Index* row, Ipopt::Index* column, Ipopt::Number* values) override;
  void finalize_solution(Ipopt::SolverReturn status, Ipopt::Index n, const Ipopt::Number* x, const Ipopt::Number* z_l, const Ipopt::Number* z_u, Ipopt::Index m, const Ipopt::Number* g, const Ipopt::Number* lambda, Ipopt::Number value, const Ipopt::IpoptData* data, Ipopt::IpoptCalculatedQuantities* quantities) override;
  // clang-format on

 private:
  const PathProblem& problem_;
  std::vector<Vec2> points_;
};

}  // namespace swathplan

#include <algorithm>

#include "planners/smoothing/path_nlp_internal.h"

namespace swathplan {
namespace {

using Ipopt::Index;
using Ipopt::Number;

/// Ipopt takes this value for 'no bound'. A bound of 0 would not do, although a norm is never below
/// 0: Ipopt keeps away from bounds, so straight stretches would be bent.
constexpr double kNoBound = -1e20;

double residual(const LinearTerm& term, const Number* x) {
  double sum = -term.target;
  for (const auto& [variable, factor] : term.parts) sum += factor * x[variable];
  return sum;
}

Vec2 combined(const NormConstraint& norm, const Number* x) {
  Vec2 sum = Vec2::Zero();
  for (const auto& [point, factor] : norm.parts) {
    const auto at = 2 * static_cast<std::ptrdiff_t>(point);
    sum += factor * Vec2(x[at], x[at + 1]);
  }
  return sum;
}

}  // namespace

bool PathNlp::get_nlp_info(Index& n, Index& m, Index& nnz_jac, Index& nnz_hess,
                           IndexStyleEnum& style) {
  n = static_cast<Index>(2 * problem_.start.size());
  m = static_cast<Index>(problem_.norms.size() + problem_.half_planes.size());
  nnz_jac = static_cast<Index>(2 * problem_.half_planes.size());
  nnz_hess = 0;
  for (const LinearTerm& term : problem_.terms) {
    const auto k = static_cast<Index>(term.parts.size());
    nnz_hess += k * (k + 1) / 2;
  }
  for (const NormConstraint& norm : problem_.norms) {
    const auto k = static_cast<Index>(norm.parts.size());
    nnz_jac += 2 * k;
    nnz_hess += k * (k + 1);
  }
  style = C_STYLE;
  return true;
}

bool PathNlp::get_bounds_info(Index, Number* x_l, Number* x_u, Index, Number* g_l, Number* g_u) {
  for (std::size_t i = 0; i < problem_.start.size(); ++i) {
    for (const int axis : {0, 1}) {
      *x_l++ = problem_.low[i][axis];
      *x_u++ = problem_.high[i][axis];
    }
  }
  for (const NormConstraint& norm : problem_.norms) {
    *g_l++ = norm.lower > 0.0 ? norm.lower : kNoBound;
    *g_u++ = norm.upper;
  }
  for (const HalfPlane& side : problem_.half_planes) {
    *g_l++ = kNoBound;
    *g_u++ = side.upper;
  }
  return true;
}

bool PathNlp::get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index, bool,
                                 Number*) {
  for (const Vec2& p : problem_.start) {
    *x++ = p.x();
    *x++ = p.y();
  }
  return true;
}

bool PathNlp::eval_f(Index, const Number* x, bool, Number& value) {
  value = 0.0;
  for (const LinearTerm& term : problem_.terms) {
    const double r = residual(term, x);
    value += 0.5 * term.weight * r * r;
  }
  return true;
}

bool PathNlp::eval_grad_f(Index n, const Number* x, bool, Number* gradient) {
  std::fill(gradient, gradient + n, 0.0);
  for (const LinearTerm& term : problem_.terms) {
    const double r = term.weight * residual(term, x);
    for (const auto& [variable, factor] : term.parts) gradient[variable] += r * factor;
  }
  return true;
}

bool PathNlp::eval_g(Index, const Number* x, bool, Index, Number* g) {
  for (const NormConstraint& norm : problem_.norms) *g++ = combined(norm, x).squaredNorm();
  for (const HalfPlane& side : problem_.half_planes) {
    const auto at = 2 * static_cast<std::ptrdiff_t>(side.point);
    *g++ = side.normal.dot(Vec2(x[at], x[at + 1]));
  }
  return true;
}

bool PathNlp::eval_jac_g(Index, const Number* x, bool, Index, Index, Index* row, Index* column,
                         Number* values) {
  for (std::size_t c = 0; c < problem_.norms.size(); ++c) {
    const NormConstraint& norm = problem_.norms[c];
    const Vec2 sum = values != nullptr ? combined(norm, x) : Vec2::Zero();
    for (const auto& [point, factor] : norm.parts) {
      for (const int axis : {0, 1}) {
        if (values != nullptr) {
          *values++ = 2.0 * factor * sum[axis];
        } else {
          *row++ = static_cast<Index>(c);
          *column++ = 2 * point + axis;
        }
      }
    }
  }
  for (std::size_t c = 0; c < problem_.half_planes.size(); ++c) {
    const HalfPlane& side = problem_.half_planes[c];
    for (const int axis : {0, 1}) {
      if (values != nullptr) {
        *values++ = side.normal[axis];
      } else {
        *row++ = static_cast<Index>(problem_.norms.size() + c);
        *column++ = 2 * side.point + axis;
      }
    }
  }
  return true;
}

bool PathNlp::eval_h(Index, const Number*, bool, Number factor, Index, const Number* lambda, bool,
                     Index, Index* row, Index* column, Number* values) {
  // The lower triangle, with one entry for each pair of parts. Ipopt adds entries of one place up.
  const auto entry = [&](int i, int j, double value) {
    if (values != nullptr) {
      *values++ = value;
    } else {
      *row++ = std::max(i, j);
      *column++ = std::min(i, j);
    }
  };
  for (const LinearTerm& term : problem_.terms) {
    for (std::size_t k = 0; k < term.parts.size(); ++k) {
      for (std::size_t l = 0; l <= k; ++l) {
        entry(term.parts[k].first, term.parts[l].first,
              factor * term.weight * term.parts[k].second * term.parts[l].second);
      }
    }
  }
  for (std::size_t c = 0; c < problem_.norms.size(); ++c) {
    const auto& parts = problem_.norms[c].parts;
    const double twice = lambda != nullptr ? 2.0 * lambda[c] : 0.0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (std::size_t l = 0; l <= k; ++l) {
        for (const int axis : {0, 1}) {
          entry(2 * parts[k].first + axis, 2 * parts[l].first + axis,
                twice * parts[k].second * parts[l].second);
        }
      }
    }
  }
  return true;
}

void PathNlp::finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*,
                                const Number*, Index, const Number*, const Number*, Number,
                                const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) {
  points_.clear();
  for (Index i = 0; i < n; i += 2) points_.emplace_back(x[i], x[i + 1]);
}

}  // namespace swathplan

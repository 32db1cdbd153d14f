#include <Eigen/SparseCholesky>
#include <array>

#include "planners/smoothing/path_relaxation_internal.h"

namespace swathplan {
namespace {

/// p_(i+3) - 3 p_(i+2) + 3 p_(i+1) - p_i, as in the problem itself.
constexpr std::array<double, 4> kThirdDifference{-1.0, 3.0, -3.0, 1.0};
/// Weight that holds an end to within rounding.
constexpr double kEndWeight = 1e6;

}  // namespace

struct PathRelaxation::Impl {
  double weight;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
      solver;

  [[nodiscard]] double weight_of(std::size_t i, std::size_t n) const {
    return i == 0 || i + 1 == n ? kEndWeight : weight;
  }
};

PathRelaxation::PathRelaxation(std::size_t points, double curvature_weight, double deviation_weight)
    : impl_(std::make_unique<Impl>()) {
  impl_->weight = deviation_weight;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < points; ++i) {
    const auto row = static_cast<int>(i);
    entries.emplace_back(row, row, impl_->weight_of(i, points));
    if (i + 3 >= points) continue;
    for (int k = 0; k < 4; ++k) {
      for (int l = 0; l < 4; ++l) {
        entries.emplace_back(row + k, row + l,
                             curvature_weight * kThirdDifference[static_cast<std::size_t>(k)] *
                                 kThirdDifference[static_cast<std::size_t>(l)]);
      }
    }
  }
  const auto n = static_cast<int>(points);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  impl_->solver.compute(matrix);
}

PathRelaxation::~PathRelaxation() = default;

std::vector<Vec2> PathRelaxation::relaxed(const std::vector<Vec2>& wanted,
                                          const std::vector<Vec2>& middle,
                                          const std::vector<double>& room) const {
  const std::size_t n = wanted.size();
  Eigen::MatrixXd right(static_cast<Eigen::Index>(n), 2);
  for (std::size_t i = 0; i < n; ++i) {
    right.row(static_cast<Eigen::Index>(i)) = impl_->weight_of(i, n) * wanted[i].transpose();
  }
  const Eigen::MatrixXd found = impl_->solver.solve(right);
  std::vector<Vec2> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 reach = Vec2::Constant(i == 0 || i + 1 == n ? 0.0 : room[i]);
    const Vec2 at = found.row(static_cast<Eigen::Index>(i)).transpose();
    result[i] = at.cwiseMax(middle[i] - reach).cwiseMin(middle[i] + reach);
  }
  return result;
}

}  // namespace swathplan

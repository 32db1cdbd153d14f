#include <fmt/format.h>

#include <IpIpoptApplication.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "planners/smoothing/path_nlp_internal.h"
#include "planners/smoothing/path_solver_internal.h"

namespace swathplan {
namespace {

constexpr double kTolerance = 1e-3;
/// Ipopt's first barrier parameter. The skeleton is near the solution, and a larger value would
/// lead away from it first.
constexpr double kFirstBarrier = 1e-2;
/// Ipopt moves the start off its bounds by this share at most.
constexpr double kBoundPush = 1e-2;
/// Norms may miss their bounds by this share of the step squared.
constexpr double kFeasible = 1e-6;

std::string status_name(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "solved";
    case Ipopt::Solved_To_Acceptable_Level:
      return "solved to acceptable level";
    case Ipopt::Infeasible_Problem_Detected:
      return "infeasible";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "iteration limit";
    case Ipopt::Restoration_Failed:
      return "restoration failed";
    default:
      return fmt::format("failed ({})", static_cast<int>(status));
  }
}

bool keeps(const NormConstraint& norm, const std::vector<Vec2>& points) {
  Vec2 sum = Vec2::Zero();
  for (const auto& [i, factor] : norm.parts) sum += factor * points[static_cast<std::size_t>(i)];
  const double dust = kFeasible * std::max(1.0, norm.upper);
  return sum.squaredNorm() >= norm.lower - dust && sum.squaredNorm() <= norm.upper + dust;
}

bool keeps(const HalfPlane& side, const std::vector<Vec2>& points) {
  const double dust = kFeasible * std::max(1.0, std::abs(side.upper));
  return side.normal.dot(points[static_cast<std::size_t>(side.point)]) <= side.upper + dust;
}

bool keeps_bounds(const PathProblem& problem, const std::vector<Vec2>& points) {
  const auto kept = [&](const auto& bound) { return keeps(bound, points); };
  return points.size() == problem.start.size() &&
         std::all_of(problem.norms.begin(), problem.norms.end(), kept) &&
         std::all_of(problem.half_planes.begin(), problem.half_planes.end(), kept);
}

}  // namespace

PathSolution solved_by_ipopt(const PathProblem& problem, int most_iterations) {
  // Ipopt's linear solver keeps global state, so only one solve may run in the whole process.
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  Ipopt::SmartPtr<PathNlp> nlp = new PathNlp(problem);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new Ipopt::IpoptApplication(false);
  app->RethrowNonIpoptException(true);
  app->Options()->SetIntegerValue("print_level", 0);
  app->Options()->SetStringValue("sb", "yes");
  app->Options()->SetIntegerValue("max_iter", most_iterations);
  app->Options()->SetNumericValue("tol", kTolerance);
  app->Options()->SetNumericValue("bound_push", kBoundPush);
  app->Options()->SetNumericValue("mu_init", kFirstBarrier);
  app->Options()->SetNumericValue("bound_relax_factor", 0.0);
  if (app->Initialize("") != Ipopt::Solve_Succeeded) return {"not started", false, {}};
  const auto status = app->OptimizeTNLP(nlp);
  bool good = status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level;
  // Good enough, though not at the optimum: the solution keeps every bound.
  if (status == Ipopt::Maximum_Iterations_Exceeded) good = keeps_bounds(problem, nlp->points());
  return {status_name(status), good, nlp->points()};
}

}  // namespace swathplan

#pragma once

#include <string>
#include <vector>

#include "planners/smoothing/path_nlp_internal.h"

namespace swathplan {

/// Ipopt's solution of a problem.
struct PathSolution {
  std::string status;        ///< Ipopt's verdict in words
  bool good = false;         ///< solved, or stopped at the iteration limit with every bound kept
  std::vector<Vec2> points;  ///< one for each point of the problem
};

/// Solves the problem from its start. One solve at a time in the whole process; deterministic.
[[nodiscard]] PathSolution solved_by_ipopt(const PathProblem& problem, int most_iterations);

}  // namespace swathplan

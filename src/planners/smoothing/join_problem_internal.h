#pragma once

#include <vector>

#include "mesh/plane/area_query.h"
#include "planners/smoothing/path_nlp_internal.h"
#include "planners/smoothing/path_solver_internal.h"
#include "planners/smoothing/smooth_samples_internal.h"
#include "planners/steering/dubins.h"

namespace swathplan {

/// A bend of a join and its least radius, as a problem for Ipopt; docs/smoothing.md states it. It
/// is solved in rounds: a bound that needs the length of a step, or the nearest edge, takes the one
/// of the round before.
class JoinProblem {
 public:
  /// `s`: the bend at even steps, from one pose to the other. `water` must outlive it.
  JoinProblem(const Pose& from, const Pose& to, const Samples& s, double radius_m,
              const AreaQuery& water);

  /// The problem at the present points, in units of the step.
  [[nodiscard]] PathProblem stated() const;
  /// Ends a round: if the solution is good, its points become the present ones.
  [[nodiscard]] PathSolution solve_round();
  /// Makes the next rounds ask for wider turns.
  void widen();
  /// Makes the next rounds keep farther from the water's edge.
  void keep_off();

  /// The bend as found, in chords of at most `chord_m`: the cubic spline through the points.
  [[nodiscard]] std::vector<Vec2> curve(double chord_m) const;

 private:
  [[nodiscard]] bool held(std::size_t i) const;
  [[nodiscard]] Vec2 scaled(const Vec2& p) const { return (p - origin_) / step_; }
  void add_terms(PathProblem& problem) const;
  void add_shape(PathProblem& problem) const;
  void add_edge(PathProblem& problem, std::size_t i) const;

  double step_, radius_;  // m; steps
  const AreaQuery& water_;
  Vec2 origin_;
  Vec2 course_from_, course_to_;
  std::vector<Vec2> given_, now_;  // one before the bend, the bend, one behind it
  double reserve_, margin_;
  bool off_ = false;
};

/// Points of a join's problem lie this far apart, radii.
inline constexpr double kJoinStep = 0.125;

}  // namespace swathplan

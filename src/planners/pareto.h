#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swathplan {

/// What counts as covered: cells with a sounding, or cells whose centre lies in a beam's footprint.
enum class Cover { hit, footprint };
[[nodiscard]] const char* name(Cover cover);

/// Length, duration and coverage of a candidate plan.
struct Outcome {
  double length_ratio = 0.0;
  double cover_pct = 0.0;  ///< covered cells, as `cover` counts them
  std::size_t turns = 0;
  double length_m = 0.0;
  double duration_s = 0.0;
  std::string what;                 ///< how the plan was made, for people
  std::size_t infeasible_legs = 0;  ///< legs that the vehicle cannot steer as drawn
  Cover cover = Cover::hit;
  /// Cells covered by whole swaths, %. Set where `cover_pct` counts only what a margin leaves of
  /// them.
  std::optional<double> whole_cover_pct = {};
  /// Hours over the least hours of the area (area_rate.h). Set by planners that save hours.
  std::optional<double> hours_ratio = {};
};
/// What the plan covers if all goes well, %: whole swaths.
[[nodiscard]] double expected_cover_pct(const Outcome& outcome);
/// '98.20 % in 1.24 h, 6620 m'.
[[nodiscard]] std::string brief(const Outcome& outcome);

/// Indices of the outcomes that no other one beats, shortest first. One plan beats another if it is
/// no longer, covers no less and has no more infeasible legs. Of equal outcomes the first one
/// stays.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<Outcome>& outcomes);

/// Hours as plans are picked by them, among those that reach what they are to cover: beyond that a
/// point of coverage more is still worth 1 % of the hours.
[[nodiscard]] double hours_to_pick_by(double duration_s, double cover_pct);
inline constexpr double kHoursOfPointBeyond = 0.01;

/// What a plan must reach; at most one of these is set.
struct PlanGoal {
  std::optional<double> coverage_pct;  ///< the shortest plan with at least this coverage
  std::optional<double> length_m;      ///< the most coverage within this length
  std::optional<double> time_s;        ///< the most coverage within this time
};

/// Whether one of them is set.
[[nodiscard]] bool any(const PlanGoal& goal);

/// Points of coverage that one more ideal length must bring where no goal is set.
inline constexpr double kWorthPerRatio = 4.0;
/// A plan with one infeasible leg less may lack this many points of coverage.
inline constexpr double kWorthPerInfeasible = 2.0;
/// kWorthPerRatio where gap-free lines take `least_ratio` ideal lengths. A fan too narrow to sweep
/// W makes every plan longer. So above kUsualRatio each ideal length must bring fewer points.
[[nodiscard]] double worth_per_ratio(double least_ratio);
inline constexpr double kUsualRatio = 2.0;

struct Pick {
  std::size_t index = 0;
  std::string why;  ///< one sentence
};
/// Chooses from outcomes (at least one). Without a goal it takes the one with the most worth() at
/// `price`. Where the goal is out of reach, it takes the most coverage, or the shortest plan. An
/// infeasible leg costs kWorthPerInfeasible points, or the ideal lengths that are worth as much.
[[nodiscard]] Pick pick(const std::vector<Outcome>& outcomes, const PlanGoal& goal,
                        double price = kWorthPerRatio);

/// The one of the outcomes at `among` (at least one) that pick() chooses.
[[nodiscard]] std::size_t pick_among(const std::vector<Outcome>& outcomes,
                                     const std::vector<std::size_t>& among, const PlanGoal& goal,
                                     double price = kWorthPerRatio);

/// Of a front (shortest first): the outcome that the goal picks, the next longer one and the next
/// shorter one. Once these are judged in full, or their gaps are filled, one of them may fit the
/// goal better. Empty without a goal.
[[nodiscard]] std::vector<std::size_t> about_the_goal(const std::vector<Outcome>& outcomes,
                                                      const std::vector<std::size_t>& front,
                                                      const PlanGoal& goal);

/// Coverage less `price` points for each ideal length and kWorthPerInfeasible for each infeasible
/// leg.
[[nodiscard]] double worth(const Outcome& outcome, double price = kWorthPerRatio);
/// Prices as multiples of one.
[[nodiscard]] std::vector<double> multiplied(std::span<const double> shares, double price);
/// Up to `count` of the outcomes at `among`: in turn the best one at each of the prices. So the
/// result holds both short plans and dense ones.
[[nodiscard]] std::vector<std::size_t> spread(const std::vector<Outcome>& outcomes,
                                              std::vector<std::size_t> among,
                                              const std::vector<double>& prices, std::size_t count);

}  // namespace swathplan

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

/// What a candidate plan costs and brings.
struct Outcome {
  double length_ratio = 0.0;
  double cover_pct = 0.0;  ///< covered cells, as `cover` counts them
  std::size_t turns = 0;
  double length_m = 0.0;
  double duration_s = 0.0;
  std::string what;                 ///< how it was made, for people
  std::size_t infeasible_legs = 0;  ///< that the vehicle cannot steer as drawn
  Cover cover = Cover::hit;
  /// Covered by whole swaths, where `cover_pct` counts only what a margin leaves of them.
  std::optional<double> whole_cover_pct = {};
};
/// What the plan covers if all goes well, %: whole swaths.
[[nodiscard]] double expected_cover_pct(const Outcome& outcome);

/// Indices of the outcomes that no other beats: none is as short or shorter with as much or more
/// coverage and no more infeasible legs. Shortest first; of equals the first given stays.
[[nodiscard]] std::vector<std::size_t> pareto_front(const std::vector<Outcome>& outcomes);

/// What a plan is asked for; at most one of them is set.
struct PlanGoal {
  std::optional<double> coverage_pct;  ///< the shortest plan with at least this coverage
  std::optional<double> length_m;      ///< the most coverage within this length
  std::optional<double> time_s;        ///< the most coverage within this time
};

/// Whether anything is.
[[nodiscard]] bool any(const PlanGoal& goal);

/// Points of coverage that one more ideal length must bring where nothing else is asked for.
inline constexpr double kWorthPerRatio = 4.0;
/// Points of coverage that a plan with one infeasible leg less may lack.
inline constexpr double kWorthPerInfeasible = 2.0;
/// The first where gap-free lines alone take `least_ratio` ideal lengths: with a fan too narrow to
/// sweep W every plan takes more of them, so each is worth less, from kUsualRatio on.
[[nodiscard]] double worth_per_ratio(double least_ratio);
inline constexpr double kUsualRatio = 2.0;

struct Pick {
  std::size_t index = 0;
  std::string why;  ///< one sentence
};
/// Chooses from outcomes (at least one). Where the goal is out of reach: the most coverage, or the
/// shortest plan. With no goal: the most of worth() at `price`. An infeasible leg counts as
/// kWorthPerInfeasible points, or the ideal lengths that are worth as much.
[[nodiscard]] Pick pick(const std::vector<Outcome>& outcomes, const PlanGoal& goal,
                        double price = kWorthPerRatio);

/// The one of the outcomes at `among` (at least one) that pick() chooses.
[[nodiscard]] std::size_t pick_among(const std::vector<Outcome>& outcomes,
                                     const std::vector<std::size_t>& among, const PlanGoal& goal,
                                     double price = kWorthPerRatio);

/// Of a front (shortest first): what the goal picks, the next longer and the next shorter one,
/// which may turn out to be what it asks for once they are judged in full or their gaps are filled;
/// empty without a goal.
[[nodiscard]] std::vector<std::size_t> about_the_goal(const std::vector<Outcome>& outcomes,
                                                      const std::vector<std::size_t>& front,
                                                      const PlanGoal& goal);

/// Coverage less `price` points for each ideal length and kWorthPerInfeasible for each infeasible
/// leg.
[[nodiscard]] double worth(const Outcome& outcome, double price = kWorthPerRatio);
/// Prices as multiples of one.
[[nodiscard]] std::vector<double> multiplied(std::span<const double> shares, double price);
/// Up to `count` of the outcomes at `among`, the best at each of the prices in turn, so that short
/// plans stand beside dense ones.
[[nodiscard]] std::vector<std::size_t> spread(const std::vector<Outcome>& outcomes,
                                              std::vector<std::size_t> among,
                                              const std::vector<double>& prices, std::size_t count);

}  // namespace swathplan

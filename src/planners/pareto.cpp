#include "planners/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace swathplan {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The index with the largest value among those for which `may` is true; kNone if there is none.
std::size_t best_of(const std::vector<Outcome>& outcomes,
                    const std::function<double(const Outcome&)>& value,
                    const std::function<bool(const Outcome&)>& may) {
  std::size_t best = kNone;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!may(outcomes[i])) continue;
    if (best == kNone || value(outcomes[i]) > value(outcomes[best])) best = i;
  }
  return best;
}

bool every(const Outcome& outcome) { return outcome.length_ratio >= 0.0; }
double infeasible_points(const Outcome& outcome) {
  return kWorthPerInfeasible * static_cast<double>(outcome.infeasible_legs);
}
double coverage(const Outcome& outcome) { return outcome.cover_pct - infeasible_points(outcome); }
double shortness(const Outcome& outcome) {
  return -outcome.length_ratio - infeasible_points(outcome) / kWorthPerRatio;
}
/// `outcome` is no shorter than `shorter`.
bool beats(const Outcome& shorter, const Outcome& outcome) {
  return shorter.cover_pct >= outcome.cover_pct &&
         shorter.infeasible_legs <= outcome.infeasible_legs;
}

Pick within(const std::vector<Outcome>& outcomes, const std::string& limit,
            const std::function<bool(const Outcome&)>& may,
            const std::function<std::string(const Outcome&)>& takes) {
  const std::size_t found = best_of(outcomes, coverage, may);
  if (found != kNone) return {found, fmt::format("the most coverage within {}", limit)};
  const std::size_t shortest = best_of(outcomes, shortness, every);
  return {shortest, fmt::format("NOT within {}: the shortest plan that was tried takes {}", limit,
                                takes(outcomes[shortest]))};
}

}  // namespace

const char* name(Cover cover) { return cover == Cover::footprint ? "footprint" : "hit"; }

double hours_to_pick_by(double duration_s, double cover_pct) {
  return duration_s / 3600.0 * (1.0 + kHoursOfPointBeyond * std::max(0.0, 100.0 - cover_pct));
}

double expected_cover_pct(const Outcome& outcome) {
  return outcome.whole_cover_pct.value_or(outcome.cover_pct);
}

std::vector<std::size_t> pareto_front(const std::vector<Outcome>& outcomes) {
  std::vector<std::size_t> order(outcomes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (outcomes[a].length_ratio != outcomes[b].length_ratio) {
      return outcomes[a].length_ratio < outcomes[b].length_ratio;
    }
    if (outcomes[a].cover_pct != outcomes[b].cover_pct) {
      return outcomes[a].cover_pct > outcomes[b].cover_pct;
    }
    return outcomes[a].infeasible_legs < outcomes[b].infeasible_legs;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool beaten = std::any_of(front.begin(), front.end(),
                                    [&](std::size_t j) { return beats(outcomes[j], outcomes[i]); });
    if (!beaten) front.push_back(i);
  }
  return front;
}

double worth(const Outcome& outcome, double price) {
  return coverage(outcome) - price * outcome.length_ratio;
}

std::vector<double> multiplied(std::span<const double> shares, double price) {
  std::vector<double> prices(shares.begin(), shares.end());
  for (double& p : prices) p *= price;
  return prices;
}

std::vector<std::size_t> spread(const std::vector<Outcome>& outcomes,
                                std::vector<std::size_t> among, const std::vector<double>& prices,
                                std::size_t count) {
  std::vector<std::size_t> list;
  while (list.size() < count && !among.empty()) {
    const double price = prices[list.size() % prices.size()];
    const auto best = std::max_element(among.begin(), among.end(), [&](auto a, auto b) {
      return worth(outcomes[a], price) < worth(outcomes[b], price);
    });
    list.push_back(*best);
    among.erase(best);
  }
  return list;
}

double worth_per_ratio(double least_ratio) {
  return kWorthPerRatio / std::max(1.0, least_ratio / kUsualRatio);
}

Pick pick(const std::vector<Outcome>& outcomes, const PlanGoal& goal, double price) {
  if (goal.coverage_pct) {
    const std::size_t found = best_of(
        outcomes, shortness, [&](const Outcome& o) { return o.cover_pct >= *goal.coverage_pct; });
    if (found != kNone) {
      return {found,
              fmt::format("the shortest plan with at least {:g} % coverage", *goal.coverage_pct)};
    }
    return {best_of(outcomes, coverage, every),
            fmt::format("the most coverage: no plan that was tried reaches {:g} %",
                        *goal.coverage_pct)};
  }
  if (goal.length_m) {
    return within(
        outcomes, fmt::format("{:g} m of path", *goal.length_m),
        [&](const Outcome& o) { return o.length_m <= *goal.length_m; },
        [](const Outcome& o) { return fmt::format("{:.0f} m", o.length_m); });
  }
  if (goal.time_s) {
    return within(
        outcomes, fmt::format("{:.4g} h", *goal.time_s / 3600.0),
        [&](const Outcome& o) { return o.duration_s <= *goal.time_s; },
        [](const Outcome& o) { return fmt::format("{:.3g} h", o.duration_s / 3600.0); });
  }
  const bool steerable = std::all_of(outcomes.begin(), outcomes.end(),
                                     [](const Outcome& o) { return o.infeasible_legs == 0; });
  return {
      best_of(
          outcomes, [&](const Outcome& o) { return worth(o, price); }, every),
      fmt::format(
          "the most coverage, less {:.2g} points for each ideal length{}", price,
          steerable ? "" : fmt::format(" and {:g} for each infeasible leg", kWorthPerInfeasible))};
}

std::string brief(const Outcome& outcome) {
  return fmt::format("{:.2f} % in {:.2f} h, {:.0f} m", outcome.cover_pct,
                     outcome.duration_s / 3600.0, outcome.length_m);
}

bool any(const PlanGoal& goal) { return goal.coverage_pct || goal.length_m || goal.time_s; }

std::size_t pick_among(const std::vector<Outcome>& outcomes, const std::vector<std::size_t>& among,
                       const PlanGoal& goal, double price) {
  std::vector<Outcome> list;
  list.reserve(among.size());
  for (const std::size_t i : among) list.push_back(outcomes[i]);
  return among[pick(list, goal, price).index];
}

std::vector<std::size_t> about_the_goal(const std::vector<Outcome>& outcomes,
                                        const std::vector<std::size_t>& front,
                                        const PlanGoal& goal) {
  if (!any(goal) || front.empty()) return {};
  const auto at = std::find(front.begin(), front.end(), pick_among(outcomes, front, goal));
  std::vector<std::size_t> list{*at};
  if (at + 1 != front.end()) list.push_back(*(at + 1));
  if (at != front.begin()) list.push_back(*(at - 1));
  return list;
}

}  // namespace swathplan

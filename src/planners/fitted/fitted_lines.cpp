#include "planners/fitted/fitted_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "planners/fitted/fewest_hours.h"
#include "planners/fitted/field_search_internal.h"
#include "planners/fitted/infill.h"
#include "planners/fitted/line_workshop.h"
#include "planners/fitted/straight_search_internal.h"
#include "planners/fronts/field_lines.h"
#include "planners/rows/survey_lines.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// All candidates together may cost this many rays: half a minute of one core.
constexpr double kRays = 4e8;
constexpr int kMostCandidates = 220;
constexpr int kFewestCandidates = 30;
/// One coarse judgement should not cost more than this many rays.
constexpr double kRaysOfOne = 4e6;
constexpr double kRaysToSteer = 3e6;
/// Sites with more rays than this in a plan are large. To join their lines and fill their gaps
/// takes tens of seconds a plan, so it is done for fewer plans.
constexpr double kRaysOfLarge = 3e7;
constexpr std::size_t kFewFinalists = 3;
/// Sites whose gap-free lines cost more rays than this are huge. One exact score takes most of a
/// minute there. So candidates are judged on cells so coarse that all of them cost about
/// kRaysOfHuge / 2, and hardly more than one plan of each kind is joined and scored in full.
constexpr double kRaysOfHuge = 2e8;
constexpr int kCoarsest = 4;
constexpr int kCandidatesOfHuge = 16;
/// Lines and joins together are about this many times as long as the gap-free lines.
constexpr double kPathOfLeast = 1.2;
constexpr double kGapOfLeast = 1.2;
/// Prices of infill: the share of W that a metre must bring. The highest price comes first.
constexpr double kInfillGains[] = {0.3, 0.13, 0.07};
/// Choices differ in length by at least this share.
constexpr double kBand = 0.001;
/// Infill is tried on the plans that are best at these multiples of the price of an ideal length.
constexpr double kInfillPrices[] = {1.0, 2.25, 3.0, 0.375, 0.6};
constexpr std::size_t kInfillOn = 5;
constexpr std::size_t kInfillOnLarge = 2;

constexpr const char* kNoLines =
    "fitted-lines: no survey line fits into the water of the survey area; check <area>, <no go> "
    "and the vehicle's draft and clearance";

/// Rays of a plan of about two ideal lengths.
double rays_of_plan(const LineWorkshop& shop) {
  const PlanOptions& o = shop.options();
  const double path = 2.0 * area_m2(shop.ground().survey_area) / lane_m(o);
  return path / shop.mean_ping_spacing_m() * o.sonar.beams;
}

/// Rays of a plan without gaps: many more where the fan is too narrow for the footprint width.
double rays_without_gaps(LineWorkshop& shop) {
  const PlanOptions& o = shop.options();
  const double path = kPathOfLeast * least_line_m(shop.raster(), shop.width(kGapOfLeast));
  return path / shop.mean_ping_spacing_m() * o.sonar.beams;
}

bool is_huge(LineWorkshop& shop) { return rays_without_gaps(shop) > kRaysOfHuge; }

bool is_large(const LineWorkshop& shop) { return rays_of_plan(shop) > kRaysOfLarge; }

SearchBudget budget_of_huge(LineWorkshop& shop) {
  const double one = kRaysOfHuge / (2.0 * kCandidatesOfHuge);
  const double coarse = std::ceil(std::sqrt(rays_without_gaps(shop) / one));
  return {.candidates = kCandidatesOfHuge,
          .coarse = std::min(kCoarsest, static_cast<int>(coarse)),
          .steered = false,
          .finalists = 2,
          .block_prices = {},
          .curved_finalists = 1};
}

SearchBudget budget_for(LineWorkshop& shop) {
  if (is_huge(shop)) return budget_of_huge(shop);
  const double rays = rays_of_plan(shop);
  SearchBudget budget;
  if (is_large(shop)) {
    budget.finalists = kFewFinalists;
    budget.block_prices = {9.0};
  }
  budget.coarse = rays > kRaysOfOne ? 2 : 1;
  // Steering a way between all lines costs seconds where there are many.
  budget.steered = rays <= kRaysToSteer;
  const double one = rays / (budget.coarse * budget.coarse);
  budget.candidates = std::clamp(static_cast<int>(kRays / one), kFewestCandidates, kMostCandidates);
  return budget;
}

std::vector<Outcome> outcomes_of(const std::vector<JudgedLines>& plans) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(plans.size());
  for (const JudgedLines& f : plans) outcomes.push_back(f.outcome);
  return outcomes;
}

/// Adds infill to the best of `plans`, and appends the results to `plans`.
void infill_best(std::vector<JudgedLines>& plans, LineWorkshop& shop) {
  const std::vector<Outcome> outcomes = outcomes_of(plans);
  const bool huge = is_huge(shop);
  const std::vector<std::size_t> front = pareto_front(outcomes);
  std::vector<std::size_t> best = about_the_goal(outcomes, front, shop.options().goal);
  const std::size_t count = huge ? 1 : is_large(shop) ? kInfillOnLarge : kInfillOn;
  for (const std::size_t i :
       spread(outcomes, front, multiplied(kInfillPrices, shop.price()), count)) {
    if (std::find(best.begin(), best.end(), i) == best.end()) best.push_back(i);
  }
  if (huge && !best.empty()) best.resize(count);
  const Watch& watch = shop.options().watch;
  watch.phase("filling gaps");
  std::size_t done = 0;
  for (const std::size_t i : best) {
    if (watch.ended()) return;
    watch.tried(done++, best.size(), {});
    const CoverageGrid grid = shop.score(plans[i].built.route).grid;
    std::size_t before = 0;
    for (const double gain : kInfillGains) {
      if (watch.ended()) return;
      InfilledRoute filled = with_infill(plans[i].built.route, grid, shop, {.least_gain = gain});
      if (filled.passes == before) continue;
      before = filled.passes;
      const std::string what = fmt::format("{}, {}", plans[i].outcome.what,
                                           counted(filled.passes, "infill pass", "infill passes"));
      plans.push_back({std::move(filled.built), {}});
      plans.back().outcome = shop.judge(plans.back().built.route, 1, what);
      if (huge) break;
    }
  }
}

/// The plans that no other beats, but of plans of nearly the same length only one: the best of
/// those with the fewest infeasible legs. So the list is short enough to read.
std::vector<std::size_t> choices_of(const std::vector<JudgedLines>& plans) {
  std::vector<std::size_t> kept;
  const auto front = pareto_front(outcomes_of(plans));
  for (auto it = front.rbegin(); it != front.rend(); ++it) {
    const bool apart = kept.empty() || plans[*it].outcome.length_ratio <
                                           (1.0 - kBand) * plans[kept.back()].outcome.length_ratio;
    if (apart) {
      kept.push_back(*it);
    } else if (plans[*it].outcome.infeasible_legs < plans[kept.back()].outcome.infeasible_legs) {
      kept.back() = *it;
    }
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

/// Lines along the area's long side, as many as W asks for.
Plan plan_without_scene(LineWorkshop& shop) {
  StraightCandidate c;
  c.azimuth_deg =
      shop.options()
          .heading.value_or(best_azimuth(shop.ground().survey_area, lane_m(shop.options())))
          .deg();
  c.lines = 0;
  BuiltRoute built = shop.with_smooth_joins(build(c, shop));
  Plan plan;
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  return plan;
}

}  // namespace

Plan plan_fitted_lines(const Ground& ground, const PlanOptions& options) {
  check(options);
  if (options.counted == Counted::logged && ground.scene != nullptr) {
    return plan_fewest_hours(ground, options);
  }
  LineWorkshop shop(ground, options);
  if (ground.scene == nullptr) return plan_without_scene(shop);
  std::vector<JudgedLines> plans;
  if (options.lines != LineSource::field) {
    for (JudgedCandidate& j : search_straight_lines(shop, budget_for(shop))) {
      plans.push_back({std::move(j.built), std::move(j.outcome)});
    }
  }
  const bool enough = options.watch.ended() && !plans.empty();
  if (options.lines != LineSource::straight && !enough) {
    for (JudgedLines& j : search_curved_lines(shop, budget_for(shop))) {
      plans.push_back(std::move(j));
    }
  }
  if (plans.empty()) throw InvalidInput(kNoLines);
  infill_best(plans, shop);
  Plan plan;
  const auto kept = choices_of(plans);
  for (const std::size_t i : kept) {
    plan.choices.push_back(plans[i].outcome);
    if (options.lines_margin > 0.0) {
      const ScoredRoute whole = shop.score(plans[i].built.route, 1, Swath::whole);
      plan.choices.back().whole_cover_pct = shop.cover_pct(whole);
    }
  }
  const Pick picked = pick(plan.choices, options.goal, shop.price());
  plan.chosen = picked.index;
  plan.chosen_why = picked.why;
  JudgedLines& best = plans[kept[picked.index]];
  options.watch.phase("joining lines");
  BuiltRoute built = shop.with_smooth_joins(std::move(best.built));
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  plan.notes.push_back(fmt::format("of {} choices, {} was picked: {}", plan.choices.size(),
                                   best.outcome.what, picked.why));
  if (options.watch.ended()) plan.notes.push_back(ended_early_note(plans.size(), "finished plan"));
  return plan;
}

}  // namespace swathplan

#include "apps/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>

#include "apps/progress.h"
#include "mesh/error.h"
#include "planners/back_and_forth.h"
#include "planners/edge_following.h"
#include "planners/fitted_lines.h"
#include "planners/mdnuc.h"
#include "planners/multi_depth.h"
#include "planners/nuc.h"

namespace swathplan {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

const std::vector<Planner>& planners() {
  static const std::vector<Planner> list{
      {"back-and-forth", "B&F", plan_back_and_forth},
      {"edge-following", "edge-following", plan_edge_following, false},
      {"multi-depth", "MDB&F", plan_multi_depth},
      {"nuc", "NUC", plan_nuc},
      {"mdnuc", "MDNUC", plan_mdnuc},
      {"fitted-lines", "fitted lines", plan_fitted_lines},
  };
  return list;
}

const Planner& planner(const std::string& name) {
  std::vector<std::string> names;
  for (const Planner& p : planners()) {
    if (p.name == name) return p;
    names.push_back(p.name);
  }
  throw UsageError(
      fmt::format("'{}' is not a planner; choose one of {}", name, fmt::join(names, ", ")));
}

Scorer::Scorer(const Site& site, const SurveyOptions& options, bool quiet)
    : options_(&options),
      score_options_(score_options(options)),
      scene_(site.seafloor(), score_options_.nodata),
      ground_{&site.seafloor(), site.depths.get(), &scene_, site.survey_area, site.water},
      quiet_(quiet) {
  // A grid that would not fit is refused before any planner works for it.
  static_cast<void>(grid_size(site.survey_area, options.resolution_m));
}

ScoredRoute Scorer::score(const std::string& label, const Route& route) const {
  ProgressBar bar(label, quiet_);
  ScoreOptions options = score_options_;
  options.progress = [&](double share, std::uint64_t rays) { bar.show(share, rays); };
  return swathplan::score(route, ground_, sonar_of(*options_), vehicle_of(*options_), options);
}

void note_endurance(const RouteFigures& figures, const Vehicle& vehicle,
                    std::vector<std::string>& notes) {
  std::string note = endurance_note(figures, vehicle);
  if (!note.empty()) notes.push_back(std::move(note));
}

PlannedSurvey plan_and_score(const Planner& planner, const Site& site, const SurveyOptions& options,
                             const Scorer& scorer) {
  const auto start = std::chrono::steady_clock::now();
  const PlanOptions how = plan_options(options, site.seafloor().frame);
  Plan plan = planner.plan(site.planning_ground(&scorer.scene()), how);
  if (how.start && !contains(site.water, *how.start) && !plan.route.waypoints.empty()) {
    const Vec2 first = site.seafloor().frame.to_file(plan.route.waypoints.front().position);
    plan.notes.push_back(
        fmt::format("--start {} is not in safe water; the route begins at {:.1f},{:.1f}",
                    options.start, first.x(), first.y()));
  }
  const double planning = seconds_since(start);
  const auto planned = std::chrono::steady_clock::now();
  ScoredRoute scored = scorer.score(planner.label, plan.route);
  note_endurance(scored.score.route, how.vehicle, plan.notes);
  return {planner.name,      planner.label, std::move(plan),
          std::move(scored), planning,      seconds_since(planned)};
}

}  // namespace swathplan

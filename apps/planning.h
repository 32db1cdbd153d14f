#pragma once

#include <string>
#include <vector>

#include "apps/site.h"
#include "coverage/score.h"
#include "planners/plan.h"

namespace swathplan {

/// A planner's name and function; the one list that `plan` and `compare` know.
struct Planner {
  std::string name, label;
  Plan (*plan)(const PlanningGround&, const PlanOptions&);
  bool usual = true;  ///< compared when no planners are named
};
[[nodiscard]] const std::vector<Planner>& planners();
/// @throws UsageError for a name that is none, listing those that are.
[[nodiscard]] const Planner& planner(const std::string& name);

/// A plan that was made and scored.
struct PlannedSurvey {
  std::string planner, label;
  Plan plan;
  ScoredRoute scored;
  double planning_seconds = 0.0, scoring_seconds = 0.0;
};

/// Notes what the survey asks of the sonar that it cannot do: a footprint width that its fan does
/// not sweep.
void note_reach(Site& site, const SurveyOptions& options);

/// What routes of one command are scored on, built once.
/// @throws UsageError for cells larger than the area or too many of them; InvalidInput for a
/// seafloor beyond the sonar's range.
class Scorer {
 public:
  Scorer(const Site& site, const SurveyOptions& options, bool quiet);
  [[nodiscard]] const RayScene& scene() const { return scene_; }
  [[nodiscard]] ScoredRoute score(const std::string& label, const Route& route) const;

 private:
  const SurveyOptions* options_;
  ScoreOptions score_options_;
  RayScene scene_;
  ScoringGround ground_;
  bool quiet_;
};

/// Adds a note if the mission does not fit into the vehicle's endurance.
void note_endurance(const RouteFigures& figures, const Vehicle& vehicle,
                    std::vector<std::string>& notes);

[[nodiscard]] PlannedSurvey plan_and_score(const Planner& planner, const Site& site,
                                           const SurveyOptions& options, const Scorer& scorer);

}  // namespace swathplan

#pragma once

#include <string>
#include <vector>

#include "apps/site.h"
#include "coverage/judging/judged_survey.h"
#include "coverage/score.h"
#include "io/results/plan_record.h"
#include "mesh/base/watch.h"
#include "planners/plan.h"

namespace swathplan {

/// A planner's name and function. `plan` and `compare` know planners from one list of these.
struct Planner {
  std::string name, label;
  Plan (*plan)(const Ground&, const PlanOptions&);
  bool usual = true;    ///< compared when no planners are named
  bool passes = false;  ///< takes a criterion as its goal (plan_to_pass)
};
[[nodiscard]] const std::vector<Planner>& planners();
/// @throws UsageError for a name that is none, listing those that are.
[[nodiscard]] const Planner& planner(const std::string& name);

/// A plan with its score and what the outputs say of it.
struct PlannedSurvey {
  PlanRecord record;
  Plan plan;
  ScoredRoute scored;
  double planning_seconds = 0.0;
  std::optional<JudgedSurvey> judged = std::nullopt;  ///< by the survey's criterion, if it has one
};
/// Records a scored plan under its name and label, with the notes of the plan, then of the site.
/// `beginnings` of its sorties, for the tide.
[[nodiscard]] PlannedSurvey recorded(const std::string& planner, const std::string& label,
                                     Plan plan, ScoredRoute scored, const Site& site,
                                     const Survey& survey,
                                     const std::vector<Beginning>& beginnings = {});

/// Adds a note if lines lie W apart and that is more than the sonar's fan sweeps.
void note_reach(Site& site, const Survey& survey);

/// The options of a planner over this site: planning_in (survey.h) with what its sonar sees, and
/// the lane that fans sweep here where lines are not W apart.
[[nodiscard]] PlanOptions planning_over(const Ground& ground, const Site& site,
                                        const Survey& survey, const Sonar& sonar);

/// What routes of one command are scored on, built once.
/// @throws UsageError for cells larger than the area or too many of them, for a ping rate that
/// sound forbids everywhere, for soundings that are out of reach everywhere; InvalidInput for a
/// seafloor beyond the sonar's range. Refuses a criterion that cannot be judged here, as
/// SurveyJudge.
class Scorer {
 public:
  Scorer(const Site& site, const Survey& survey, Watch watch);
  Scorer(const Scorer&) = delete;  // its ground points to its scene
  Scorer& operator=(const Scorer&) = delete;
  [[nodiscard]] const Ground& ground() const { return ground_; }
  /// Where no fan and no speed lays a ping in each cell by the clock, and what comes nearest; empty
  /// where all is in reach.
  [[nodiscard]] const std::string& reach_note() const { return reach_note_; }
  [[nodiscard]] const Watch& watch() const { return watch_; }
  /// `phase` is what the watch is told.
  [[nodiscard]] ScoredRoute score(const std::string& phase, const Route& route) const;
  /// Judges by the survey's criterion; null without one.
  [[nodiscard]] const SurveyJudge* judge() const { return judge_ ? &*judge_ : nullptr; }
  /// By the survey's criterion; empty if it has none.
  [[nodiscard]] std::optional<JudgedSurvey> judge(const std::string& phase,
                                                  const Route& route) const;

 private:
  const Site* site_;
  const Survey* survey_;
  RayScene scene_;
  Ground ground_;
  std::optional<SurveyJudge> judge_;
  double least_hours_ = 0.0;
  double goal_pct_ = 0.0;
  std::string reach_note_;
  Watch watch_;
};

/// Adds a note if the route runs on where the sonar reaches no data.
void note_beyond_data(const Score& score, std::vector<std::string>& notes);

/// Adds a note if the route has corners that cannot be sailed as drawn.
void note_corners(const RouteFigures& figures, const Vehicle& vehicle,
                  std::vector<std::string>& notes);

/// Adds a note if a leg is sailed faster than the vehicle can.
void note_speed(const Route& route, const Vehicle& vehicle, std::vector<std::string>& notes);

/// Adds a note if the mission does not fit into the vehicle's endurance.
void note_endurance(const RouteFigures& figures, const Vehicle& vehicle,
                    std::vector<std::string>& notes);

/// The options of the planner over this site: its sonar is narrowed to what the criterion accepts.
[[nodiscard]] PlanOptions planning_for(const Site& site, const Survey& survey, const Scorer& scorer,
                                       std::vector<std::string>& notes);
/// The planner's plan, not scored yet. @throws InvalidInput where no line fits.
[[nodiscard]] Plan made_plan(const Planner& planner, const Site& site, const Survey& survey,
                             const Scorer& scorer);
/// Scores, judges and records a plan. `one_sortie`: the vehicle's endurance is held against it all.
[[nodiscard]] PlannedSurvey scored_plan(const std::string& name, const std::string& label,
                                        Plan plan, const Site& site, const Survey& survey,
                                        const Scorer& scorer, bool one_sortie = true,
                                        const std::vector<Beginning>& beginnings = {});

[[nodiscard]] PlannedSurvey plan_and_score(const Planner& planner, const Site& site,
                                           const Survey& survey, const Scorer& scorer);

}  // namespace swathplan

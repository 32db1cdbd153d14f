#pragma once

#include <optional>
#include <string>

#include "apps/options.h"
#include "coverage/judging/judged_survey.h"
#include "coverage/score.h"
#include "io/results/provenance.h"
#include "io/seafloor/import_seafloor.h"
#include "planners/plan.h"

namespace swathplan {

/// What a survey is judged by.
struct Judging {
  const Criterion* criterion = nullptr;
  UncertaintyBudget budget;
  JudgingOptions how;
  bool require_pass = false;
};

/// What a survey is planned and scored with, made once from what was typed.
struct Survey {
  Sonar sonar;
  Vehicle vehicle;
  PlanOptions planning;  ///< without its start and heading, which the seafloor's frame places
  ScoreOptions scoring;
  std::optional<Judging> judging;  ///< empty: by no criterion
  std::optional<Vec2> start_xy;    ///< where to begin, in the coordinates of the seafloor's file
  std::string start_text;          ///< the same as it was typed
  std::optional<double> heading_deg;
  std::optional<double> asked_soundings, asked_ping_rate_hz;  ///< where they were typed
  std::string north;  ///< that it counts from: 'true' or 'grid'
};

/// @throws UsageError that names flag, value and rule.
[[nodiscard]] Sonar sonar_of(const SonarChoice& choice);
[[nodiscard]] Vehicle vehicle_of(const VehicleChoice& choice);
[[nodiscard]] Survey survey_of(const SurveyOptions& options);

/// The options of the planner, its start and heading placed in the frame of the data.
/// @throws UsageError for a start that has no place there.
[[nodiscard]] PlanOptions planning_in(const Survey& survey, const ImportedSeafloor& data);

/// The azimuth in the frame of the data: `north` is 'true' or 'grid'.
[[nodiscard]] Angle grid_heading(double heading_deg, const std::string& north,
                                 const ImportedSeafloor& data);

/// What was typed, with the values that follow from it where none was given.
[[nodiscard]] VehicleChoice in_force(const VehicleChoice& typed, const Vehicle& vehicle);
[[nodiscard]] SurveyOptions in_force(const SurveyOptions& typed, const Survey& survey);

[[nodiscard]] ImportOptions import_options(const SiteOptions& options);

/// What made an output; options are recorded into it.
[[nodiscard]] Provenance provenance_of(const std::string& command, const SiteOptions& site,
                                       const std::string& input_hash);
/// Records the rows of a set whose values in force are those that were typed.
void record(Provenance& provenance, const OptionTable& options);
/// Records sonar, vehicle, tracking errors and scoring.
void record_scoring(Provenance& provenance, const SurveyOptions& typed, const Survey& survey);
void record_planning(Provenance& provenance, const SurveyOptions& typed, const Survey& survey);

}  // namespace swathplan

#pragma once

#include <string>
#include <vector>

#include "apps/planning.h"
#include "io/results/score_json.h"

namespace swathplan {

/// Checks before the work of planning that the folder for results can be made and written to.
/// Leaves everything as it was. @throws InvalidInput if not.
void check_folder(const std::filesystem::path& folder);
/// Removes the named files of an earlier run, if they are there.
void remove_old(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Writes route, score, plan, coverage and holidays of one survey into `folder`.
void write_survey(const std::filesystem::path& folder, const PlannedSurvey& survey,
                  const Site& site, const Provenance& provenance);
/// Removes what an older survey left in `folder` and a new one need not replace: its exports, the
/// routes of its sorties, and files in or without a CRS.
void remove_old_survey(const std::filesystem::path& folder, const Site& site);

/// Writes the report over one or several surveys.
void write_survey_report(const std::filesystem::path& file, const std::string& title,
                         const std::vector<PlannedSurvey>& surveys, const Site& site,
                         const Provenance& provenance);

/// Which of several plans is the best, and why, as a line of text; empty for a single one.
[[nodiscard]] std::string best_of(const std::vector<PlannedSurvey>& surveys);

/// The table that `plan`, `compare` and `score` print.
[[nodiscard]] std::string table(const std::vector<PlannedSurvey>& surveys);

/// What the criterion says of each survey that was judged, rule by rule; empty without one.
[[nodiscard]] std::string verdicts(const std::vector<PlannedSurvey>& surveys);

/// What score_json() is to say of the criterion.
[[nodiscard]] JudgedIn judged_in(const PlannedSurvey& survey, const Site& site);

/// @throws PredictedToFail if the criterion was required to pass and the survey is predicted to
/// fail.
void check_passes(const PlannedSurvey& planned, const Survey& survey);

/// The choices that a planner offers, with a mark at the picked one; empty if it offers none.
[[nodiscard]] std::string choices_table(const Plan& plan);

/// Prints the notes and warnings of the import to stderr.
void print_notes(const Site& site, bool quiet);

}  // namespace swathplan

#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/site_command.h"
#include "apps/watch/terminal_watch.h"
#include "coverage/route/leg_table.h"
#include "io/results/score_json.h"
#include "io/route/read_route.h"
#include "mesh/base/error.h"
#include "planners/fitted/infill.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

struct ScoreCommand : SiteCommand {
  std::filesystem::path route;
  std::filesystem::path legs;
  std::optional<double> opening_deg;
  bool infill = false;
};

/// The rows of this command alone.
OptionTable own_options(ScoreCommand& command) {
  return {
      real("--opening-angle", "Route", command.opening_deg, kDegrees, between(0.0, 180.0),
           "Full opening angle where ROUTE has none, degrees (default: as wide as --max-opening "
           "and range allow at the mean depth)",
           "opening_angle_deg"),
      path("--legs", "Route", command.legs,
           "The table of angles, speeds and logging that stands beside an export "
           "(route.legs.csv), for ROUTE files that hold none",
           "legs"),
      swath_option("Route", command.survey.planning.swath_by),
      flag("--infill", "Route", command.infill,
           "Also add passes over the gaps: a second route, in the folder 'infill'", "infill")};
}

Provenance provenance_of(const ScoreCommand& command, const Survey& survey,
                         const std::string& input_hash) {
  Provenance provenance = site_provenance("score", command, survey, input_hash);
  ScoreCommand typed = command;
  record(provenance, own_options(typed));
  return provenance;
}

/// The fan for routes that give none.
FanAngles default_fan(const ScoreCommand& command, const Survey& survey, const Site& site) {
  if (!command.opening_deg) return fan_where_none(survey, site);
  const Angle half = Angle::degrees(*command.opening_deg / 2.0);
  return {half, half};
}

/// The route with the angles, speeds and logging of a leg table.
Route with_table(const Route& route, const std::filesystem::path& file, const Frame& frame) {
  const Route table = read_route(file, frame, {}).route;
  try {
    return with_leg_table(route, table);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("'{}': {}", file.string(), error.what()));
  }
}

/// The route with extra passes over its gaps.
Plan with_passes(const Plan& plan, const Survey& survey, const Site& site, const Scorer& scorer) {
  PlanOptions how = planning_over(scorer.ground(), site, survey, survey.sonar);
  how.watch = scorer.watch();
  how.watch.phase("adding infill passes");
  InfilledRoute filled = infilled(plan.route, scorer.ground(), how);
  Plan result;
  result.route = std::move(filled.built.route);
  result.notes = std::move(filled.built.notes);
  result.notes.push_back(
      fmt::format("{} added", counted(filled.passes, "infill pass was", "infill passes were")));
  if (how.watch.ended()) {
    result.notes.push_back("search ended early: gaps that were not looked at yet stay");
  }
  return result;
}

/// Prints the notes on the route as given, then on the one with infill.
void print_notes(const std::vector<PlannedSurvey>& surveys) {
  for (const PlannedSurvey& survey : surveys) {
    for (const std::string& note : survey.plan.notes) {
      if (surveys.size() == 1)
        fmt::print(stderr, "note: {}\n", note);
      else
        fmt::print(stderr, "note: {}: {}\n", survey.record.label, note);
    }
  }
}

void run(const ScoreCommand& command) {
  const Survey survey = survey_of(command.survey);
  const Vehicle& vehicle = survey.vehicle;
  TerminalWatch watch(command.output.quiet, command.output.folder);
  const auto site = site_of(command, survey, watch);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance = provenance_of(command, survey, site->imported.input_hash);
  const ImportedRoute route =
      read_route(command.route, site->seafloor().frame,
                 {.fan = default_fan(command, survey, *site), .speed_mps = vehicle.speed_mps});
  check_meets_data(route.route, *site, command.route);
  Plan plan;
  plan.route = route.route;
  if (!command.legs.empty()) {
    plan.route = with_table(route.route, command.legs, site->seafloor().frame);
  } else if (route.fan_note) {
    plan.notes.push_back(*route.fan_note);
  }
  plan.notes.insert(plan.notes.end(), route.notes.begin(), route.notes.end());
  const Scorer scorer(*site, survey, Watch(watch));
  ScoredRoute scored = scorer.score("scoring", plan.route);
  note_beyond_data(scored.score, plan.notes);
  note_corners(scored.score.route, vehicle, plan.notes);
  note_speed(plan.route, vehicle, plan.notes);
  note_endurance(scored.score.route, vehicle, plan.notes);
  std::vector<PlannedSurvey> surveys;
  const std::string name = command.route.filename().string();
  std::optional<Plan> filled;
  if (command.infill) watch.search();
  if (command.infill) filled = with_passes(plan, survey, *site, scorer);
  surveys.push_back(recorded("given", name, std::move(plan), std::move(scored), *site, survey));
  surveys[0].judged = scorer.judge("judging by the criterion", surveys[0].plan.route);
  const std::filesystem::path& folder = command.output.folder;
  if (filled) {
    ScoredRoute again = scorer.score("scoring with infill", filled->route);
    note_corners(again.score.route, vehicle, filled->notes);
    note_endurance(again.score.route, vehicle, filled->notes);
    surveys.push_back(recorded("infill", name + " + infill", std::move(*filled), std::move(again),
                               *site, survey));
    surveys[1].judged = scorer.judge("judging with infill", surveys[1].plan.route);
  }
  watch.phase("writing results");
  const auto writing = watch.writing();
  write_all_or_none(folder, [&](const std::filesystem::path& staging) {
    if (filled) write_survey(staging / "infill", surveys[1], *site, provenance);
    write_survey(staging, surveys[0], *site, provenance);
    write_survey_toml(staging, provenance);
    write_survey_report(staging / "report.html",
                        fmt::format("{}: {}", command.site.file.filename().string(), name), surveys,
                        *site, provenance);
    if (filled) remove_old_survey(folder / "infill", *site);
    remove_old_survey(folder, *site);
  });
  watch.rest();
  if (!command.output.quiet) print_notes(surveys);
  if (command.output.json) {
    // With infill, --json prints the figures of the new route.
    fmt::print("{}", score_json(surveys.back().record.planner, surveys.back().scored.score,
                                provenance, judged_in(surveys.back(), *site)));
  } else if (!command.output.quiet) {
    fmt::print("{}{}report: {}\n", table(surveys), verdicts(surveys),
               (folder / "report.html").string());
  }
  check_passes(surveys.back(), survey);
}

}  // namespace

Command score_command() {
  auto command = std::make_shared<ScoreCommand>();
  return {
      "score",
      "Score any route: of this program, of an autopilot, chart system or survey package",
      joined({site_rows(*command),
              {argument(
                  "ROUTE", command->route,
                  "route.csv or another CSV, GeoJSON, .plan, .waypoints, GPX, KML, RTZ, LNW, RLN, "
                  "asciiplan, DXF, GeoPackage, YAML of a ROS path")},
              scoring_options(command->survey),
              criteria_options(command->survey.criteria),
              own_options(*command),
              output_options(command->output)}),
      [command] { run(*command); },
      {}};
}

}  // namespace swathplan

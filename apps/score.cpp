#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/outputs.h"
#include "io/results/score_json.h"
#include "io/route/read_route.h"
#include "mesh/base/error.h"
#include "planners/fitted/infill.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

struct ScoreCommand {
  SiteOptions site;
  SurveyOptions survey;
  OutputOptions output;
  std::filesystem::path route;
  std::optional<double> opening_deg;
  bool infill = false;
};

/// The fan for routes that do not say: --opening-angle, else W at the mean depth.
FanAngles default_fan(const ScoreCommand& command, const Site& site) {
  if (command.opening_deg) {
    const double opening = *command.opening_deg;
    if (!(opening > 0.0 && opening < 180.0)) {
      throw UsageError(fmt::format(
          "--opening-angle {:g}; must lie between 0 and 180 degrees, both excluded", opening));
    }
    return {Angle::degrees(opening / 2.0), Angle::degrees(opening / 2.0)};
  }
  return fan_for_depth(plan_options(command.survey, {}), depth_range(site.seafloor()).mean);
}

/// A route that nowhere comes near the data is in another CRS or of another place.
void check_meets_data(const Route& route, const Site& site, const std::filesystem::path& file) {
  Box2 box = extent(site.seafloor());
  const double reach = std::max(100.0, box.size().norm());
  box.min.array() -= reach;
  box.max.array() += reach;
  Box2 of_route;
  for (const Waypoint& w : route.waypoints) of_route.extend(w.position);
  const bool apart = (of_route.min.array() > box.max.array()).any() ||
                     (of_route.max.array() < box.min.array()).any();
  if (!apart) return;
  throw InvalidInput(fmt::format(
      "'{}': the route lies outside the seafloor's data; check that both are in the same CRS "
      "(lon_deg,lat_deg or the coordinates of the seafloor's file)",
      file.string()));
}

/// The route with extra passes over its gaps.
Plan with_passes(const Plan& plan, const ScoreCommand& command, const Site& site,
                 const Scorer& scorer) {
  InfilledRoute filled = infilled(plan.route, site.planning_ground(&scorer.scene()),
                                  plan_options(command.survey, site.seafloor().frame));
  Plan result;
  result.route = std::move(filled.built.route);
  result.notes = std::move(filled.built.notes);
  result.notes.push_back(
      fmt::format("{} added", counted(filled.passes, "infill pass was", "infill passes were")));
  return result;
}

/// What is to be said of the route as given, then of the one with infill.
void print_notes(const std::vector<PlannedSurvey>& surveys) {
  for (const PlannedSurvey& survey : surveys) {
    for (const std::string& note : survey.plan.notes) {
      if (surveys.size() == 1)
        fmt::print(stderr, "note: {}\n", note);
      else
        fmt::print(stderr, "note: {}: {}\n", survey.label, note);
    }
  }
}

void run(const ScoreCommand& command) {
  static_cast<void>(score_options(command.survey));
  const Vehicle vehicle = vehicle_of(command.survey);
  const auto site = load_site(command.site, vehicle);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance =
      provenance_of("score", command.site, command.survey, site->imported.input_hash);
  const ImportedRoute route =
      read_route(command.route, site->seafloor().frame,
                 {.fan = default_fan(command, *site), .speed_mps = vehicle.speed_mps});
  check_meets_data(route.route, *site, command.route);
  Plan plan;
  plan.route = route.route;
  plan.notes = route.notes;
  const Scorer scorer(*site, command.survey, command.output.quiet);
  ScoredRoute scored = scorer.score("score", plan.route);
  note_endurance(scored.score.route, vehicle, plan.notes);
  std::vector<PlannedSurvey> surveys;
  const std::string name = command.route.filename().string();
  std::optional<Plan> filled;
  if (command.infill) filled = with_passes(plan, command, *site, scorer);
  surveys.push_back({"given", name, std::move(plan), std::move(scored), 0.0, 0.0});
  const std::filesystem::path& folder = command.output.folder;
  if (filled) {
    ScoredRoute again = scorer.score("infill", filled->route);
    note_endurance(again.score.route, vehicle, filled->notes);
    surveys.push_back(
        {"infill", name + " + infill", std::move(*filled), std::move(again), 0.0, 0.0});
    write_survey(folder / "infill", surveys[1], *site, command.survey, provenance);
  }
  write_survey(folder, surveys[0], *site, command.survey, provenance);
  write_survey_report(folder / "report.html",
                      fmt::format("{}: {}", command.site.file.filename().string(), name), surveys,
                      *site, command.survey, provenance);
  if (!command.output.quiet) print_notes(surveys);
  if (command.output.json) {
    // With infill the figures asked for are those of the route that was made.
    fmt::print("{}", score_json(surveys.back().planner, surveys.back().scored.score, provenance));
  } else if (!command.output.quiet) {
    fmt::print("{}report: {}\n", table(surveys), (folder / "report.html").string());
  }
}

}  // namespace

void add_score_command(CLI::App& app) {
  auto* sub = app.add_subcommand("score", "Score any route.csv or GeoJSON line, ours or not");
  auto command = std::make_shared<ScoreCommand>();
  add_site_options(*sub, command->site);
  sub->add_option("ROUTE", command->route, "route.csv, another CSV of points, or GeoJSON")
      ->required();
  sub->add_option(
      "--opening-angle", command->opening_deg,
      "Full opening angle where ROUTE has none, degrees (default: W at the mean depth)");
  sub->add_flag("--infill", command->infill,
                "Also add passes over the gaps: a second route, in the folder 'infill'");
  add_scoring_options(*sub, command->survey);
  add_output_options(*sub, command->output);
  sub->callback([command] { run(*command); });
}

}  // namespace swathplan

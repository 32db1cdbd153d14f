#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/job/job_request.h"
#include "apps/job/job_texts.h"
#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/site_command.h"
#include "apps/watch/terminal_watch.h"
#include "coverage/route/over_land.h"
#include "io/results/score_json.h"
#include "io/route/read_route.h"
#include "io/route/route_csv.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct PlanCommand : SiteCommand {
  ExportChoice exports;
  JobChoice job;
  std::string planner = "fitted-lines";
};

/// The rows of this command alone.
OptionTable own_options(PlanCommand& command) {
  std::vector<std::string> names;
  for (const Planner& p : planners()) names.push_back(p.name);
  return {
      chooser(choice("--planner", "Planning", command.planner, names, "What plans", "planner"))};
}

Provenance provenance_of(const PlanCommand& command, const Survey& survey,
                         const std::string& input_hash) {
  Provenance provenance = site_provenance("plan", command, survey, input_hash);
  PlanCommand typed = command;
  record(provenance, own_options(typed));
  record_planning(provenance, typed.survey, survey);
  record(provenance, job_options(typed.job));
  record(provenance, exporting_options(typed.exports));
  return provenance;
}

/// Lines to make a job of, and what they are called.
struct MainScheme {
  Plan plan;
  std::string name, label;
};

/// The lines of a route that was made before.
MainScheme kept_lines(const PlanCommand& command, const Site& site, const Survey& survey) {
  const std::filesystem::path& file = command.job.keep;
  ImportedRoute route =
      read_route(file, site.seafloor().frame,
                 {.fan = fan_where_none(survey, site), .speed_mps = survey.vehicle.speed_mps});
  check_meets_data(route.route, site, file);
  MainScheme kept{{}, "kept", file.filename().string()};
  kept.plan.route = std::move(route.route);
  if (route.fan_note) kept.plan.notes.push_back(*route.fan_note);
  kept.plan.notes.insert(kept.plan.notes.end(), route.leg_notes.begin(), route.leg_notes.end());
  kept.plan.notes.insert(kept.plan.notes.end(), route.notes.begin(), route.notes.end());
  return kept;
}

MainScheme lines_beside(const PlanCommand& command, const JobRequest& request, const Site& site,
                        const PlanOptions& how, const Scorer& scorer) {
  Plan plan =
      plan_beside(shapes_beside(site, command.job, request), request.beside, scorer.ground(), how);
  if (plan.route.waypoints.size() < 2) {
    throw InvalidInput(fmt::format(
        "--beside {}: no line of {:g} m or more beside it lies in safe water of the survey area; "
        "check its place, or lower --spacing or --least-line",
        command.job.beside, how.least_line_m));
  }
  return {std::move(plan), "beside", "lines beside"};
}

/// The survey that begins at the berth, if it is not to begin elsewhere.
Survey begun_at(const Survey& survey, const std::optional<Vec2>& berth, const Site& site) {
  Survey begun = survey;
  if (berth && !begun.start_xy) {
    begun.start_xy = in_file_of(site.imported, *berth);
    begun.start_text = fmt::format("{},{}", begun.start_xy->x(), begun.start_xy->y());
  }
  return begun;
}

/// A scored survey, and the routes of its sorties where it is divided.
struct PlannedJob {
  PlannedSurvey survey;
  std::vector<Route> routes;
  std::vector<std::string> stems;
};

/// When each sortie sets out, after the departure. Days of daylight count from the midnight before
/// it.
std::vector<Beginning> beginnings_of(const JobSummary& job, const std::vector<Route>& routes,
                                     const std::optional<double>& departure_s) {
  constexpr double kDayS = 86400.0;
  const double since_midnight =
      job.by_daylight && departure_s ? std::fmod(*departure_s, kDayS) : 0.0;
  std::vector<Beginning> beginnings;
  std::size_t waypoint = 0;
  for (std::size_t i = 0; i < routes.size(); ++i) {
    beginnings.push_back({waypoint, job.sorties[i].begins_s - since_midnight});
    waypoint += routes[i].waypoints.size() - 1;  // sorties share the berth's waypoint
  }
  return beginnings;
}

PlannedJob planned_job(const PlanCommand& command, const JobRequest& request, const Site& site,
                       const Survey& survey, const Scorer& scorer) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::string> notes = request.notes;
  JobOptions job = request.job;
  job.berth = berth_in(site, request, survey.vehicle, notes);
  const Survey begun = begun_at(survey, job.berth, site);
  const bool planner_runs = command.job.keep.empty() && command.job.beside.empty();
  const PlanOptions how = planning_for(site, begun, scorer, notes);
  MainScheme main;
  if (planner_runs) {
    const Planner& chosen = planner(command.planner);
    main = {made_plan(chosen, site, begun, scorer), chosen.name, chosen.label};
  } else {
    main = command.job.keep.empty() ? lines_beside(command, request, site, how, scorer)
                                    : kept_lines(command, site, survey);
  }
  Plan& plan = main.plan;
  std::vector<Route> routes;
  std::vector<std::string> stems;
  std::optional<JobSummary> summary;
  std::vector<Beginning> beginnings;
  if (request.any() || !command.job.keep.empty()) {
    scorer.watch().phase("making the whole job");
    Job made = whole_job(plan.route, scorer.ground(), how, job);
    plan.route = std::move(made.route);
    routes = std::move(made.routes);
    for (Route& sortie : routes) mark_over_land(sortie, site.land);
    summary = std::move(made.summary);
    beginnings = beginnings_of(*summary, routes, site.departure_s);
    stems = sortie_stems(*summary);
    notes.insert(notes.end(), made.notes.begin(), made.notes.end());
    const auto said = job_notes(*summary, cross_figures(plan.route));
    notes.insert(notes.end(), said.begin(), said.end());
  }
  for (std::string& note : notes) {
    const bool known = std::find(plan.notes.begin(), plan.notes.end(), note) != plan.notes.end();
    if (!known) plan.notes.push_back(std::move(note));
  }
  const double planning =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  PlannedSurvey survey_of_all = scored_plan(main.name, main.label, std::move(plan), site, survey,
                                            scorer, stems.empty(), beginnings);
  survey_of_all.planning_seconds = planning;
  survey_of_all.record.job = std::move(summary);
  for (const std::string& stem : stems) survey_of_all.record.job_files.push_back(stem + ".csv");
  return {std::move(survey_of_all), std::move(routes), std::move(stems)};
}

/// Writes the route of each sortie, and its exports.
std::vector<ExportedRoute> write_sorties(const std::filesystem::path& folder, const PlannedJob& job,
                                         const Site& site, const ExportOptions& exports) {
  std::vector<ExportedRoute> exported;
  for (std::size_t i = 0; i < job.stems.size(); ++i) {
    write_route_csv(folder / (job.stems[i] + ".csv"), job.routes[i], site.seafloor().frame);
    WrittenExports written = write_exports(folder, job.routes[i], site, exports, job.stems[i]);
    for (ExportedRoute& file : written.files) exported.push_back(std::move(file));
  }
  return exported;
}

void run(const PlanCommand& command) {
  // Everything typed is resolved and checked before any work.
  static_cast<void>(planner(command.planner));
  const Survey survey = survey_of(command.survey);
  const JobRequest request =
      job_request(command.job, command.survey.planning.spacing_m, survey.vehicle);
  const ExportOptions exports = export_options(command.exports);
  TerminalWatch watch(command.output.quiet, command.output.folder);
  const auto site = site_of(command, survey, watch);
  check_export_crs(exports.formats, site->seafloor().frame);
  note_reach(*site, survey);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance = provenance_of(command, survey, site->imported.input_hash);
  const auto plan_all = [&] {
    const Scorer scorer(*site, survey, Watch(watch));
    watch.search();
    return planned_job(command, request, *site, survey, scorer);
  };
  PlannedJob job = plan_all();
  std::vector<PlannedSurvey> surveys;
  surveys.push_back(std::move(job.survey));
  const std::filesystem::path& folder = command.output.folder;
  const PlannedSurvey& planned = surveys[0];
  const Route& route = planned.plan.route;
  const std::string title =
      fmt::format("{}: {}", command.site.file.filename().string(), planned.record.label);
  WrittenExports exported;
  watch.phase("writing results");
  const auto writing = watch.writing();
  write_all_or_none(folder, [&](const std::filesystem::path& staging) {
    write_survey(staging, planned, *site, provenance);
    write_survey_toml(staging, provenance);
    exported = write_exports(staging, route, *site, exports);
    for (ExportedRoute& file : write_sorties(staging, job, *site, exports)) {
      exported.files.push_back(std::move(file));
    }
    write_survey_report(staging / "report.html", title, surveys, *site, provenance);
    remove_old_survey(folder, *site);
  });
  watch.rest();
  print_exports(std::move(exported.files), folder, route, command.output.quiet);
  for (const std::string& note : planned.plan.notes) {
    if (!command.output.quiet) fmt::print(stderr, "note: {}\n", note);
  }
  if (!command.output.quiet) fmt::print(stderr, "{}", choices_table(planned.plan));
  if (command.output.json) {
    fmt::print("{}", score_json(planned.record.planner, planned.scored.score, provenance,
                                judged_in(planned, *site)));
  } else if (!command.output.quiet) {
    const std::string said = planned.record.job ? job_table(*planned.record.job) : std::string();
    fmt::print("{}{}{}report: {}\n", table(surveys), verdicts(surveys), said,
               (folder / "report.html").string());
  }
  check_passes(planned, survey);
}

}  // namespace

Command plan_command() {
  auto command = std::make_shared<PlanCommand>();
  return {"plan",
          "Plan a survey with one planner: route, score, report",
          joined({site_rows(*command), scoring_options(command->survey),
                  criteria_options(command->survey.criteria), own_options(*command),
                  planning_options(command->survey.planning), job_options(command->job),
                  exporting_options(command->exports), output_options(command->output)}),
          [command] { run(*command); },
          {}};
}

}  // namespace swathplan

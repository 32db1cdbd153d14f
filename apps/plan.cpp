#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/watch/terminal_watch.h"
#include "io/results/score_json.h"

namespace swathplan {
namespace {

struct PlanCommand {
  SiteOptions site;
  SurveyOptions survey;
  OutputOptions output;
  ExportChoice exports;
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
  Provenance provenance = provenance_of("plan", command.site, input_hash);
  PlanCommand typed = command;
  record_scoring(provenance, typed.survey, survey);
  record(provenance, own_options(typed));
  record_planning(provenance, typed.survey, survey);
  record(provenance, exporting_options(typed.exports));
  return provenance;
}

void run(const PlanCommand& command) {
  // Everything typed is resolved and checked before any work.
  const Planner& chosen = planner(command.planner);
  const Survey survey = survey_of(command.survey);
  const ExportOptions exports = export_options(command.exports);
  TerminalWatch watch(command.output.quiet, command.output.folder);
  const auto site = load_site(command.site, survey.vehicle, Watch(watch));
  check_export_crs(exports.formats, site->seafloor().frame);
  note_reach(*site, survey);
  watch.rest();
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance = provenance_of(command, survey, site->imported.input_hash);
  std::vector<PlannedSurvey> surveys;
  {
    const Scorer scorer(*site, survey, Watch(watch));
    watch.search();
    surveys.push_back(plan_and_score(chosen, *site, survey, scorer));
  }
  const std::filesystem::path& folder = command.output.folder;
  const Route& route = surveys[0].plan.route;
  const std::string title =
      fmt::format("{}: {}", command.site.file.filename().string(), chosen.label);
  WrittenExports exported;
  watch.phase("writing results");
  const auto writing = watch.writing();
  write_all_or_none(folder, [&](const std::filesystem::path& staging) {
    write_survey(staging, surveys[0], *site, provenance);
    write_survey_toml(staging, provenance);
    exported = write_exports(staging, route, *site, exports);
    write_survey_report(staging / "report.html", title, surveys, *site, provenance);
    remove_old_survey(folder, *site);
  });
  watch.rest();
  print_exports(std::move(exported.files), folder, route, command.output.quiet);
  for (const std::string& note : surveys[0].plan.notes) {
    if (!command.output.quiet) fmt::print(stderr, "note: {}\n", note);
  }
  if (!command.output.quiet) fmt::print(stderr, "{}", choices_table(surveys[0].plan));
  if (command.output.json) {
    fmt::print("{}", score_json(chosen.name, surveys[0].scored.score, provenance,
                                judged_in(surveys[0], *site)));
  } else if (!command.output.quiet) {
    fmt::print("{}{}report: {}\n", table(surveys), verdicts(surveys),
               (folder / "report.html").string());
  }
  check_passes(surveys[0], survey);
}

}  // namespace

Command plan_command() {
  auto command = std::make_shared<PlanCommand>();
  return {"plan",
          "Plan a survey with one planner: route, score, report",
          joined({site_options(command->site), scoring_options(command->survey),
                  criteria_options(command->survey.criteria), own_options(*command),
                  planning_options(command->survey.planning), exporting_options(command->exports),
                  output_options(command->output)}),
          [command] { run(*command); },
          {}};
}

}  // namespace swathplan

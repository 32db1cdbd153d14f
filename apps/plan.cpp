#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outputs.h"
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

void run(const PlanCommand& command) {
  const Planner& chosen = planner(command.planner);
  // Everything typed is checked before any work.
  static_cast<void>(plan_options(command.survey, {}));
  static_cast<void>(score_options(command.survey));
  const ExportOptions exports = export_options(command.exports);
  const auto site = load_site(command.site, vehicle_of(command.survey));
  check_export_crs(exports.formats, site->seafloor().frame);
  note_reach(*site, command.survey);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance =
      provenance_of("plan", command.site, command.survey, site->imported.input_hash);
  std::vector<PlannedSurvey> surveys;
  {
    const Scorer scorer(*site, command.survey, command.output.quiet);
    surveys.push_back(plan_and_score(chosen, *site, command.survey, scorer));
  }
  const std::filesystem::path& folder = command.output.folder;
  write_survey(folder, surveys[0], *site, command.survey, provenance);
  write_exports(folder, surveys[0].plan.route, *site, exports, command.output.quiet);
  const std::string title =
      fmt::format("{}: {}", command.site.file.filename().string(), chosen.label);
  write_survey_report(folder / "report.html", title, surveys, *site, command.survey, provenance);
  for (const std::string& note : surveys[0].plan.notes) {
    if (!command.output.quiet) fmt::print(stderr, "note: {}\n", note);
  }
  if (!command.output.quiet) fmt::print(stderr, "{}", choices_table(surveys[0].plan));
  if (command.output.json) {
    fmt::print("{}", score_json(chosen.name, surveys[0].scored.score, provenance));
  } else if (!command.output.quiet) {
    fmt::print("{}report: {}\n", table(surveys), (folder / "report.html").string());
  }
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto* sub = app.add_subcommand("plan", "Plan a survey with one planner: route, score, report");
  auto command = std::make_shared<PlanCommand>();
  add_site_options(*sub, command->site);
  std::string names;
  for (const Planner& p : planners()) names += (names.empty() ? "" : ", ") + p.name;
  sub->add_option("--planner", command->planner, "One of " + names)->capture_default_str();
  add_planning_options(*sub, command->survey);
  add_scoring_options(*sub, command->survey);
  add_export_options(*sub, command->exports);
  add_output_options(*sub, command->output);
  sub->callback([command] { run(*command); });
}

}  // namespace swathplan

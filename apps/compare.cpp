#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outputs.h"
#include "io/files/atomic_file.h"
#include "io/results/score_json.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct CompareCommand {
  SiteOptions site;
  SurveyOptions survey;
  OutputOptions output;
  ExportChoice exports;
  std::vector<std::string> planners;
};

/// A planner that finds no plan does not take the others with it, unless it was the last hope.
void leave_out(const Planner& planner, const InvalidInput& why, Site& site, bool none_left) {
  if (none_left) throw why;
  site.notes.push_back(fmt::format("{} is left out: {}", planner.label, why.what()));
  fmt::print(stderr, "warning: {}\n", site.notes.back());
}

void run(const CompareCommand& command) {
  std::vector<const Planner*> chosen;
  for (const std::string& name : command.planners) chosen.push_back(&planner(name));
  if (chosen.empty()) throw UsageError("--planners: name at least one planner");
  static_cast<void>(plan_options(command.survey, {}));
  static_cast<void>(score_options(command.survey));
  const ExportOptions exports = export_options(command.exports);
  const auto site = load_site(command.site, vehicle_of(command.survey));
  check_export_crs(exports.formats, site->seafloor().frame);
  note_reach(*site, command.survey);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance =
      provenance_of("compare", command.site, command.survey, site->imported.input_hash);
  const std::filesystem::path& folder = command.output.folder;
  // A run that is cut short must not leave the page of an older one beside its own results.
  remove_old(folder, {"compare.json", "report.html"});
  std::vector<PlannedSurvey> surveys;
  auto json = nlohmann::ordered_json::array();
  const auto write_overview = [&] {
    write_text_atomically(folder / "compare.json", json.dump(2) + "\n");
    write_survey_report(folder / "report.html", command.site.file.filename().string(), surveys,
                        *site, command.survey, provenance);
  };
  {
    const Scorer scorer(*site, command.survey, command.output.quiet);
    for (const Planner* p : chosen) {
      // The last one takes longest as a rule; if it is cut short, the others still have a page.
      if (p == chosen.back() && !surveys.empty()) write_overview();
      try {
        surveys.push_back(plan_and_score(*p, *site, command.survey, scorer));
      } catch (const InvalidInput& e) {
        leave_out(*p, e, *site, surveys.empty() && p == chosen.back());
        continue;
      }
      const PlannedSurvey& survey = surveys.back();
      write_survey(folder / survey.planner, survey, *site, command.survey, provenance);
      write_exports(folder / survey.planner, survey.plan.route, *site, exports,
                    command.output.quiet);
      json.push_back(nlohmann::ordered_json::parse(
          score_json(survey.planner, survey.scored.score, provenance)));
      for (const std::string& note : survey.plan.notes) {
        if (!command.output.quiet) fmt::print(stderr, "note: {}: {}\n", survey.label, note);
      }
      if (!command.output.quiet) fmt::print(stderr, "{}", choices_table(survey.plan));
    }
  }
  write_overview();  // with the notes on planners that were left out
  if (command.output.json) {
    fmt::print("{}\n", json.dump(2));
  } else if (!command.output.quiet) {
    fmt::print("{}report: {}\n", table(surveys), (folder / "report.html").string());
  }
}

}  // namespace

void add_compare_command(CLI::App& app) {
  auto* sub = app.add_subcommand("compare", "Plan with several planners: one table, one report");
  auto command = std::make_shared<CompareCommand>();
  for (const Planner& p : planners()) {
    if (p.usual) command->planners.push_back(p.name);
  }
  add_site_options(*sub, command->site);
  sub->add_option("--planners", command->planners, "Names, separated by commas")
      ->delimiter(',')
      ->capture_default_str();
  add_planning_options(*sub, command->survey);
  add_scoring_options(*sub, command->survey);
  add_export_options(*sub, command->exports);
  add_output_options(*sub, command->output);
  sub->callback([command] { run(*command); });
}

}  // namespace swathplan

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/site_command.h"
#include "apps/watch/terminal_watch.h"
#include "io/files/atomic_file.h"
#include "io/results/score_json.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct CompareCommand : SiteCommand {
  ExportChoice exports;
  std::vector<std::string> planners;
};

/// The row of this command alone.
OptionTable own_options(CompareCommand& command) {
  return {chooser(
      texts("--planners", "Planning", command.planners, "Names, separated by commas", "planners"))};
}

Provenance provenance_of(const CompareCommand& command, const Survey& survey,
                         const std::string& input_hash) {
  Provenance provenance = site_provenance("compare", command, survey, input_hash);
  CompareCommand typed = command;
  record(provenance, own_options(typed));
  record_planning(provenance, typed.survey, survey);
  record(provenance, exporting_options(typed.exports));
  return provenance;
}

/// A planner that finds no plan is left out, and the others go on; it is an error only if no
/// planner is left. A note of every plan says so, also of plans that were made before.
void leave_out(const Planner& planner, const InvalidInput& why, Site& site,
               std::vector<PlannedSurvey>& surveys, bool none_left) {
  if (none_left) throw why;
  site.notes.push_back(fmt::format("{} is left out: {}", planner.label, in_flags(why)));
  for (PlannedSurvey& survey : surveys) survey.record.notes.push_back(site.notes.back());
  fmt::print(stderr, "warning: {}\n", site.notes.back());
}

void run(const CompareCommand& command) {
  std::vector<const Planner*> chosen;
  for (const std::string& name : command.planners) chosen.push_back(&planner(name));
  if (chosen.empty()) throw UsageError("--planners: name at least one planner");
  const Survey how = survey_of(command.survey);
  const ExportOptions exports = export_options(command.exports);
  TerminalWatch watch(command.output.quiet, command.output.folder);
  const auto site = site_of(command, how, watch);
  check_export_crs(exports.formats, site->seafloor().frame);
  note_reach(*site, how);
  print_notes(*site, command.output.quiet);
  check_folder(command.output.folder);
  const Provenance provenance = provenance_of(command, how, site->imported.input_hash);
  const std::filesystem::path& folder = command.output.folder;
  // If this run is stopped early, the page of an older run must not stand beside the new results.
  remove_old(folder, {"compare.json", "report.html"});
  write_survey_toml(folder, provenance);
  std::vector<PlannedSurvey> surveys;
  auto json = nlohmann::ordered_json::array();
  const auto write_overview = [&] {
    watch.phase("writing the comparison");
    const auto writing = watch.writing();
    write_all_or_none(folder, [&](const std::filesystem::path& staging) {
      write_text_atomically(staging / "compare.json", json.dump(2) + "\n");
      write_survey_report(staging / "report.html", command.site.file.filename().string(), surveys,
                          *site, provenance);
    });
  };
  {
    const Scorer scorer(*site, how, Watch(watch));
    watch.search();
    for (const Planner* p : chosen) {
      if (watch.ended() && !surveys.empty()) {
        leave_out(*p, InvalidInput("the search ended early"), *site, surveys, false);
        continue;
      }
      // The last planner usually takes longest. If it is stopped, the others still have a page.
      if (p == chosen.back() && !surveys.empty()) write_overview();
      watch.under(p->label);
      try {
        surveys.push_back(plan_and_score(*p, *site, how, scorer));
      } catch (const InvalidInput& e) {
        watch.rest();
        leave_out(*p, e, *site, surveys, surveys.empty() && p == chosen.back());
        continue;
      }
      const PlannedSurvey& survey = surveys.back();
      const std::filesystem::path own = folder / survey.record.planner;
      WrittenExports exported;
      watch.phase("writing results");
      const auto writing = watch.writing();
      write_all_or_none(own, [&](const std::filesystem::path& staging) {
        write_survey(staging, survey, *site, provenance);
        exported = write_exports(staging, survey.plan.route, *site, exports);
        remove_old_survey(own, *site);
      });
      watch.rest();
      print_exports(std::move(exported.files), own, survey.plan.route, command.output.quiet);
      json.push_back(nlohmann::ordered_json::parse(
          score_json(survey.record.planner, survey.scored.score, provenance)));
      for (const std::string& note : survey.plan.notes) {
        if (!command.output.quiet) fmt::print(stderr, "note: {}: {}\n", survey.record.label, note);
      }
      if (!command.output.quiet) fmt::print(stderr, "{}", choices_table(survey.plan));
    }
  }
  watch.under({});
  write_overview();  // with the notes on planners that were left out
  watch.rest();
  if (command.output.json) {
    fmt::print("{}\n", json.dump(2));
  } else if (!command.output.quiet) {
    fmt::print("{}report: {}\n", table(surveys), (folder / "report.html").string());
  }
}

}  // namespace

Command compare_command() {
  auto command = std::make_shared<CompareCommand>();
  for (const Planner& p : planners()) {
    if (p.usual) command->planners.push_back(p.name);
  }
  return {"compare",
          "Plan with several planners: one table, one report",
          joined({site_rows(*command), scoring_options(command->survey), own_options(*command),
                  planning_options(command->survey.planning), exporting_options(command->exports),
                  output_options(command->output)}),
          [command] { run(*command); },
          {}};
}

}  // namespace swathplan

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

/// The plans of one command, written as they come.
class Comparison {
 public:
  Comparison(const CompareCommand& command, const Survey& how, TerminalWatch& watch)
      : command_(command),
        how_(how),
        exports_(export_options(command.exports)),
        watch_(watch),
        site_(site_of(command, how, watch)),
        folder_(command.output.folder) {
    check_export_crs(exports_.formats, site_->seafloor().frame);
    note_reach(*site_, how_);
    print_notes(*site_, command_.output.quiet);
    check_folder(folder_);
    provenance_ = provenance_of(command_, how_, site_->imported.input_hash);
    // If this run is stopped early, the page of an older run must not stand beside the new results.
    remove_old(folder_, {"compare.json", "report.html"});
    write_survey_toml(folder_, provenance_);
  }

  void plan_all(const std::vector<const Planner*>& chosen) {
    const Scorer scorer(*site_, how_, Watch(watch_));
    watch_.search();
    for (const Planner* p : chosen) {
      if (watch_.ended() && !surveys_.empty()) {
        leave_out(*p, InvalidInput("the search ended early"), false);
        continue;
      }
      // The last planner usually takes longest. If it is stopped, the others still have a page.
      if (p == chosen.back() && !surveys_.empty()) write_overview();
      watch_.under(p->label);
      try {
        surveys_.push_back(plan_and_score(*p, *site_, how_, scorer));
      } catch (const InvalidInput& e) {
        watch_.rest();
        leave_out(*p, e, surveys_.empty() && p == chosen.back());
        continue;
      }
      write(surveys_.back());
    }
    watch_.under({});
    write_overview();  // with the notes on planners that were left out
    watch_.rest();
  }

  void print() const {
    if (command_.output.json) {
      fmt::print("{}\n", json_.dump(2));
    } else if (!command_.output.quiet) {
      fmt::print("{}{}report: {}\n", table(surveys_), best_of(surveys_),
                 (folder_ / "report.html").string());
    }
  }

 private:
  /// A planner that finds no plan is left out, and the others go on; it is an error only if no
  /// planner is left. A note of every plan says so, also of plans that were made before.
  void leave_out(const Planner& planner, const InvalidInput& why, bool none_left) {
    if (none_left) throw why;
    site_->notes.push_back(fmt::format("{} is left out: {}", planner.label, in_flags(why)));
    for (PlannedSurvey& survey : surveys_) survey.record.notes.push_back(site_->notes.back());
    fmt::print(stderr, "warning: {}\n", site_->notes.back());
  }

  /// The folder of one plan.
  void write(const PlannedSurvey& survey) {
    const std::filesystem::path own = folder_ / survey.record.planner;
    WrittenExports exported;
    watch_.phase("writing results");
    const auto writing = watch_.writing();
    write_all_or_none(own, [&](const std::filesystem::path& staging) {
      write_survey(staging, survey, *site_, provenance_);
      exported = write_exports(staging, survey.plan.route, *site_, exports_);
      remove_old_survey(own, *site_);
    });
    watch_.rest();
    json_.push_back(nlohmann::ordered_json::parse(
        score_json(survey.record.planner, survey.scored.score, provenance_)));
    print_exports(std::move(exported.files), own, survey.plan.route, command_.output.quiet);
    if (command_.output.quiet) return;
    for (const std::string& note : survey.plan.notes) {
      fmt::print(stderr, "note: {}: {}\n", survey.record.label, note);
    }
    fmt::print(stderr, "{}", choices_table(survey.plan));
  }

  /// What holds the plans so far against each other.
  void write_overview() {
    watch_.phase("writing the comparison");
    const auto writing = watch_.writing();
    write_all_or_none(folder_, [&](const std::filesystem::path& staging) {
      write_text_atomically(staging / "compare.json", json_.dump(2) + "\n");
      write_survey_report(staging / "report.html", command_.site.file.filename().string(), surveys_,
                          *site_, provenance_);
    });
  }

  const CompareCommand& command_;
  const Survey& how_;
  ExportOptions exports_;
  TerminalWatch& watch_;
  std::unique_ptr<Site> site_;
  std::filesystem::path folder_;
  Provenance provenance_;
  std::vector<PlannedSurvey> surveys_;
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
};

void run(const CompareCommand& command) {
  std::vector<const Planner*> chosen;
  for (const std::string& name : command.planners) chosen.push_back(&planner(name));
  if (chosen.empty()) throw UsageError("--planners: name at least one planner");
  const Survey how = survey_of(command.survey);
  TerminalWatch watch(command.output.quiet, command.output.folder);
  Comparison comparison(command, how, watch);
  comparison.plan_all(chosen);
  comparison.print();
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

#include "apps/outputs.h"

#include <fmt/format.h>

#include "apps/commands.h"
#include "io/charts/hazards_geojson.h"
#include "io/exports/route_export.h"
#include "io/files/atomic_file.h"
#include "io/pictures/coverage_png.h"
#include "io/pictures/coverage_tif.h"
#include "io/pictures/uncertainty_tif.h"
#include "io/report/report.h"
#include "io/results/holidays_geojson.h"
#include "io/results/plan_json.h"
#include "io/results/score_json.h"
#include "io/route/route_csv.h"
#include "io/route/route_geojson.h"
#include "io/seafloor/inspection.h"
#include "io/water/legs_csv.h"
#include "planners/wording.h"

namespace swathplan {

void check_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::path made;  // the topmost folder that is not there yet
  for (std::filesystem::path p = std::filesystem::absolute(folder, ignored);
       !p.empty() && !std::filesystem::exists(p, ignored) && p != p.parent_path();
       p = p.parent_path()) {
    made = p;
  }
  const std::filesystem::path probe = folder / ".swathplan-probe";
  write_text_atomically(probe, "");
  std::filesystem::remove(probe, ignored);
  if (!made.empty()) std::filesystem::remove_all(made, ignored);
}

void remove_old(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::error_code error;
    if (std::filesystem::is_regular_file(folder / name, error)) {
      std::filesystem::remove(folder / name, error);
    }
  }
}

void write_survey(const std::filesystem::path& folder, const PlannedSurvey& survey,
                  const Site& site, const Provenance& provenance) {
  const Frame& frame = site.seafloor().frame;
  write_route_csv(folder / "route.csv", survey.plan.route, frame);
  write_route_geojson(folder, survey.plan.route, frame);
  write_score_json(folder / "score.json", survey.record.planner, survey.scored.score, provenance,
                   judged_in(survey, site));
  write_plan_json(folder / "plan.json", survey.record, frame, provenance);
  write_coverage_tif(folder / "coverage.tif", survey.scored.grid, frame);
  write_coverage_png(folder / "coverage.png", survey.scored.grid, survey.record.label,
                     survey.scored.score.logged_counts);
  write_holidays_geojson(folder, survey.scored.score.holidays, frame);
  if (!site.hazards.list.empty()) write_hazards_geojson(folder, site.hazards, frame);
  if (site.is_timed()) {
    write_text_atomically(folder / "water.csv",
                          legs_csv(survey.plan.route, survey.water, site.departure_s));
  }
  if (survey.judged) {
    write_tvu_tif(folder / "tvu.tif", survey.judged->raster, frame);
    write_thu_tif(folder / "thu.tif", survey.judged->raster, frame);
  }
}

namespace {

/// Routes of an earlier run's sorties, whichever their number, and their exports.
void remove_old_sorties(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("route_boat") || name.starts_with("route_sortie")) names.push_back(name);
  }
  remove_old(folder, names);
}

}  // namespace

void remove_old_survey(const std::filesystem::path& folder, const Site& site) {
  // Left by a run on other data: with a CRS where this has none, or without.
  remove_old(folder,
             site.seafloor().frame.crs_wkt.empty()
                 ? std::vector<std::string>{"route.geojson", "holidays.geojson"}
                 : std::vector<std::string>{"route.local.geojson", "holidays.local.geojson"});
  remove_old(folder, {"tvu.tif", "thu.tif", "hazards.geojson", "water.csv"});
  remove_exports(folder, "route", all_export_formats());
  remove_old_sorties(folder);
}

namespace {

std::vector<ReportPlan> report_plans(const std::vector<PlannedSurvey>& surveys) {
  std::vector<ReportPlan> plans;
  for (const PlannedSurvey& s : surveys) {
    plans.push_back({&s.record, &s.plan.route, &s.scored.score, &s.scored.grid, s.planning_seconds,
                     s.judged ? &*s.judged : nullptr});
  }
  return plans;
}

}  // namespace

void write_survey_report(const std::filesystem::path& file, const std::string& title,
                         const std::vector<PlannedSurvey>& surveys, const Site& site,
                         const Provenance& provenance) {
  ReportSite report;
  report.title = title;
  report.seafloor = &site.seafloor();
  report.depths = site.depths.get();
  report.survey_area = site.survey_area;
  report.water = site.water;
  report.no_go = site.no_go;
  report.provenance = provenance;
  write_report(file, report, report_plans(surveys));
}

std::string best_of(const std::vector<PlannedSurvey>& surveys) {
  const std::string best = best_of_plans(report_plans(surveys));
  return best.empty() ? best : best + "\n";
}

std::string table(const std::vector<PlannedSurvey>& surveys) {
  std::string text =
      fmt::format("{:<16}{:>9}{:>9}{:>11}{:>9}{:>8}{:>9}{:>10}{:>10}{:>10}{:>9}{:>8}{:>8}\n",
                  "planner", "hit %", "logged %", "footpr. %", "length m", "ratio", "overlap",
                  "turns", "holidays", "outside m", "tight m", "infeas.", "hours");
  for (const PlannedSurvey& s : surveys) {
    const Score& score = s.scored.score;
    text += fmt::format(
        "{:<16}{:>9.2f}{:>9.2f}{:>11}{:>9.0f}{:>8.2f}{:>9.2f}{:>10}{:>10}{:>10.1f}{:>9.1f}{:>8}{"
        ":>8.2f}\n",
        s.record.label, score.all.hit_pct, score.logged.hit_pct,
        score.all.footprint_pct ? fmt::format("{:.2f}", *score.all.footprint_pct) : "-",
        score.route.length_m, score.route.length_ratio, score.overlap, score.route.turns,
        score.holidays.count, score.route.outside_water_m, score.route.tight_turn_m,
        score.route.infeasible_legs, score.route.duration_s / 3600.0);
  }
  for (const PlannedSurvey& s : surveys) {
    const auto& whole = s.scored.score.whole;
    if (!whole) continue;
    text += fmt::format(
        "{}: {:.2f} % of the whole survey area are covered, with what was covered before ({:.2f} "
        "%)\n",
        s.record.label, whole->logged_pct, whole->before_pct);
  }
  return text;
}

std::string verdicts(const std::vector<PlannedSurvey>& surveys) {
  std::string text;
  for (const PlannedSurvey& s : surveys) {
    if (!s.judged) continue;
    const Verdict& verdict = s.judged->verdict;
    text += fmt::format("{}: predicted to {} {}\n", s.record.label, verdict.pass ? "pass" : "fail",
                        verdict.title);
    for (const JudgedRule& rule : verdict.rules) {
      text += fmt::format("  {} {:<23} {} (asked: {})\n", rule.pass ? "passes" : "FAILS ",
                          rule.name, rule.figure, rule.asks);
    }
    const OutOfReach& out = s.judged->out_of_reach;
    if (out.total_m2() > 0.0) {
      text += fmt::format(
          "  not judged: {:.0f} m2 out of reach ({:.0f} m2 that no place in safe water shows to "
          "the "
          "sonar, {:.0f} m2 shown only from places that the boat cannot be steered through or held "
          "at)\n",
          out.total_m2(), out.hidden_m2, out.unsteerable_m2);
    }
  }
  return text;
}

JudgedIn judged_in(const PlannedSurvey& survey, const Site& site) {
  if (!survey.judged) return {};
  return {&*survey.judged, &site.seafloor().frame};
}

void check_passes(const PlannedSurvey& planned, const Survey& survey) {
  if (!survey.judging || !survey.judging->require_pass || planned.judged->verdict.pass) return;
  throw PredictedToFail(planned.record.label + ": " + sentence(planned.judged->verdict));
}

std::string choices_table(const Plan& plan) {
  if (plan.choices.empty()) return {};
  std::string text = fmt::format("choices ({}):\n", plan.chosen_why);
  for (std::size_t i = 0; i < plan.choices.size(); ++i) {
    const Outcome& o = plan.choices[i];
    text += fmt::format(
        "{} {:>6.2f} % {}{} over {:>7.0f} m ({}, {}{}): {}\n", i == plan.chosen ? '*' : ' ',
        expected_cover_pct(o), name(o.cover),
        o.whole_cover_pct ? fmt::format(" ({:.2f} % without the margin)", o.cover_pct) : "",
        o.length_m,
        o.hours_ratio
            ? fmt::format("{:.2f} h, {:.2f} times the least", o.duration_s / 3600.0, *o.hours_ratio)
            : fmt::format("{:.2f} ideal lengths", o.length_ratio),
        counted(o.turns, "turn"),
        o.infeasible_legs > 0 ? fmt::format(", {} infeasible", o.infeasible_legs) : "", o.what);
  }
  return text;
}

void print_notes(const Site& site, bool quiet) {
  if (quiet) return;
  for (const std::string& note : site.imported.notes)
    fmt::print(stderr, "note: {}\n", in_flags(note));
  for (const std::string& note : site.notes) fmt::print(stderr, "note: {}\n", note);
  for (const std::string& warning : warnings_of(site.imported))
    fmt::print(stderr, "warning: {}\n", in_flags(warning));
}

}  // namespace swathplan

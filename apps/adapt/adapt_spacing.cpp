#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numeric>
#include <sstream>

#include "apps/adapt/adapt_common.h"
#include "apps/adapt/adapt_live.h"
#include "apps/adapt/adapt_planners.h"
#include "apps/adapt/live_curves.h"
#include "io/files/atomic_file.h"
#include "io/results/adaptive_study.h"
#include "mesh/base/error.h"
#include "mesh/base/random.h"
#include "planners/adaptive/spacing_missions.h"

namespace swathplan {
namespace {

struct SpacingCommand {
  BoxOptions box;
  AdaptOutput output;
  SiteOptions site;  ///< its no-go polygons alone
  TrackSpacingOptions planner;
  SpacingWorld world;
  std::filesystem::path curve;
  bool control = false, as_published = false;
  double border_m = 20.0;
  int components = 2;
  int missions = 20;
};

// 'range,p' a line, '#' starts a comment; a first line that starts with a letter is a heading.
DetectionCurve read_curve(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw InvalidInput(fmt::format("{} cannot be opened", path.string()));
  DetectionCurve curve;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    if (number == 1 && std::isalpha(static_cast<unsigned char>(line[0])) != 0) continue;
    std::istringstream fields(line);
    double range = 0.0;
    double p = 0.0;
    char comma = 0;
    std::string rest;
    if (!(fields >> range >> comma >> p) || comma != ',' || (fields >> rest)) {
      throw InvalidInput(fmt::format("{} line {}: '{}' is not 'range_m,p'", path.string(), number,
                                     line.substr(0, 60)));
    }
    curve.range_m.push_back(range);
    curve.p.push_back(p);
  }
  if (curve.p.empty()) {
    throw InvalidInput(
        fmt::format("{} holds no P(y) curve; give a line 'range_m,p' per point", path.string()));
  }
  check(curve, path.string());
  return curve;
}

TrackSpacingOptions planner_of(const SpacingCommand& c) {
  TrackSpacingOptions options = c.planner;
  options.adapt = !c.control;
  options.careful = !c.as_published;
  check(options);
  return options;
}

SpacingWorld world_of(const SpacingCommand& c) {
  SpacingWorld world = c.world;
  world.seed = c.output.seed;
  if (!c.curve.empty()) world.truth = read_curve(c.curve);
  return world;
}

std::vector<double> profile(const ResidualRiskMap& map) {
  std::vector<double> mean(static_cast<std::size_t>(map.columns), 0.0);
  for (std::size_t i = 0; i < map.risk.size(); ++i) {
    mean[i % mean.size()] += map.risk[i] / map.rows;
  }
  return mean;
}

double mean_risk(const std::vector<double>& values) {
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 1.0 : sum / static_cast<double>(values.size());
}

OptionTable planner_options(SpacingCommand& c) {
  return joined(
      {{real("--width", "", c.planner.width_m, kMetres, any_number(),
             "Of the area across the tracks, m", "width_m"),
        real("--length", "", c.planner.length_m, kMetres, any_number(), "Of a track, m",
             "length_m"),
        real("--range", "", c.planner.range_m, kMetres, any_number(),
             "Range r believed good at the start, m", "range_m"),
        real("--nadir", "", c.planner.nadir_m, kMetres, any_number(),
             "Nadir gap r_n to each side, m", "nadir_m"),
        real("--threshold", "", c.planner.threshold, kNoUnit, any_number(),
             "Smallest P(y) of good data", "threshold"),
        flag("--as-published", "", c.as_published,
             "No second thoughts within a pair, spare width at the far edge", "as_published")},
       box_options(c.box),
       adapt_output_options(c.output)});
}

OptionTable world_options(SpacingCommand& c) {
  return {whole("--trials", "", c.world.trials, at_least(0.0),
                "Targets tried per range bin and track; 0: the planner is given the true curve",
                "trials"),
          real("--scatter", "", c.world.scatter, kNoUnit, within(0.0, 0.99),
               "Relative deviation of P from cell to cell", "scatter"),
          real("--border", "", c.border_m, kMetres, at_least(0.0),
               "Border left out of risk figures, m", "border_m"),
          whole("--components", "", c.components, within(1.0, 6.0), "Gaussians of the mixture",
                "components")};
}

OptionTable mission_options(SpacingCommand& c) {
  return {flag("--control", "", c.control, "Do not adapt", "control"),
          path("--curve", "", c.curve, "True P(y): a file of 'range_m,p' lines", "curve_file"),
          no_go_option(c.site.no_go)};
}

Provenance provenance(const SpacingCommand& c, const TrackSpacingOptions& o,
                      const std::string& mode, bool with_world) {
  SpacingCommand typed = c;
  OptionTable rows = planner_options(typed);
  if (with_world) rows = joined({std::move(rows), world_options(typed), mission_options(typed)});
  Provenance provenance = adapt_provenance("adapt spacing " + mode, rows, rows);
  for (const auto& [name, value] : {std::pair("adapt", o.adapt), std::pair("careful", o.careful)}) {
    provenance.options.emplace_back(name, value);
    provenance.derived.emplace_back(name);
  }
  return provenance;
}

TrackPicture picture_of(const std::string& title, const TrackSpacingOptions& o,
                        const std::vector<SurveyTrack>& tracks) {
  return {title, o.width_m, o.length_m, tracks, {}, "", {}};
}

void simulate(const SpacingCommand& c) {
  const TrackSpacingOptions o = planner_of(c);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  const SpacingMission mission = sail(o, world_of(c));
  TrackSpacingOptions control = o;
  control.adapt = false;
  const SpacingMission reference = sail(control, world_of(c));
  const auto risks = looked_at(without_border(mission.risk, c.border_m));
  const auto mixture = fitted_mixture(risks, c.components);
  const WorstComponent worst = worst_component(risks, c.components);
  MissionOutput out = mission_output(box, mission.state.sailed, o.range_m, flat_depth_m(o.range_m),
                                     provenance(c, o, "simulate", true));
  out.planner = "spacing";
  out.label = o.adapt ? "Track spacing (adaptive)" : "Track spacing (control)";
  out.figures = {{"tracks", static_cast<double>(mission.state.sailed.size())},
                 {"length_m", length_m(out.route)},
                 {"first_range_m", mission.state.ranges_m.front()},
                 {"last_range_m", mission.state.ranges_m.back()},
                 {"good_range_m", mission.state.good_range_m},
                 {"uncovered_pct", 100.0 * uncovered_share(mission.risk)},
                 {"uncovered_inside_border_pct",
                  100.0 * uncovered_share(without_border(mission.risk, c.border_m))},
                 {"mean_risk", mean_risk(risks)},
                 {"worst_component_mean_risk", worst.median},
                 {"worst_component_mean_risk_lowest", worst.lowest},
                 {"worst_component_mean_risk_highest", worst.highest},
                 {"worst_component_sigma", mixture.back().sigma},
                 {"worst_component_share", mixture.back().share}};
  if (mission.state.range_too_short) {
    out.notes.push_back(
        fmt::format("data was good to less than 3 r_n = {:g} m: paired tracks "
                    "cannot close their nadir gaps and gaps are left",
                    3.0 * o.nadir_m));
  }
  TrackPicture first = picture_of("Control: fixed spacing", o, reference.state.sailed);
  first.shade = profile(reference.risk);
  first.shade_label = "dark: high residual risk";
  TrackPicture second = picture_of(out.label, o, mission.state.sailed);
  second.shade = profile(mission.risk);
  second.shade_label = first.shade_label;
  out.pictures = {first, second};
  std::filesystem::create_directories(c.output.folder);
  const auto counts = histogram(looked_at(mission.risk), 50);
  const auto control_counts = histogram(looked_at(reference.risk), 50);
  Chart chart{"Residual risk of the cells that were looked at", "residual risk", "cells", {}};
  ChartCurve adaptive{o.adapt ? "adaptive" : "this mission", {}, {}, false};
  ChartCurve fixed{"control", {}, {}, true};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    adaptive.x.push_back((static_cast<double>(i) + 0.5) / 50.0);
    adaptive.y.push_back(counts[i]);
    fixed.x.push_back(adaptive.x.back());
    fixed.y.push_back(control_counts[i]);
  }
  chart.curves = {adaptive, fixed};
  write_chart_png(c.output.folder / "risk-histogram.png", chart);
  keep_out_of(abstract_no_go(c.site, box, o.range_m, out), {}, out);
  write_flat_mission(c.output, out, box, o.range_m);
}

// Of the fits in a study, whose missions tell the spread themselves.
constexpr int kStudyStarts = 3;

constexpr std::array<double, 4> kTrueRanges{120.0, 130.0, 140.0, 150.0};

// The example curve stretched beyond its peak so that it reaches the threshold at `range`.
DetectionCurve curve_to(double range) {
  DetectionCurve curve = example_curve();
  for (double& y : curve.range_m) {
    if (y > 70.0) y = 70.0 + (y - 70.0) * (range - 70.0) / 60.0;
  }
  return curve;
}

std::vector<double> study_cell(const SpacingCommand& c, std::size_t cell, std::size_t starts) {
  const double start = 120.0 + 5.0 * static_cast<double>(cell % starts);
  const double range = kTrueRanges[cell / starts];
  std::vector<double> sums(8, 0.0);
  for (int i = 0; i < c.missions; ++i) {
    SpacingWorld world = c.world;
    world.truth = curve_to(range);
    world.seed = mixed_seed(c.output.seed, cell, static_cast<std::uint64_t>(i));
    for (const bool adapt : {false, true}) {
      TrackSpacingOptions o = planner_of(c);
      o.range_m = start;
      o.adapt = adapt;
      const auto mission = sail(o, world);
      const auto risks = looked_at(without_border(mission.risk, c.border_m));
      const std::size_t at = adapt ? 4 : 0;
      sums[at] += static_cast<double>(mission.state.sailed.size());
      sums[at + 1] += 100.0 * uncovered_share(mission.risk);
      sums[at + 2] += mean_risk(risks);
      sums[at + 3] += worst_component(risks, c.components, kStudyStarts, false).median;
    }
  }
  std::vector<double> row{range, start};
  for (const double s : sums) row.push_back(s / c.missions);
  return row;
}

void study(const SpacingCommand& c) {
  const TrackSpacingOptions o = planner_of(c);
  constexpr std::size_t kStarts = 7;
  const auto limit = thread_limit(c.output);
  Study s{
      "spacing",
      fmt::format("seed {} missions {} width_m {} length_m {} nadir_m {} threshold {} trials {} "
                  "scatter {} careful {} components {} border_m {}",
                  c.output.seed, c.missions, o.width_m, o.length_m, o.nadir_m, o.threshold,
                  c.world.trials, c.world.scatter, o.careful, c.components, c.border_m),
      {"true_range_m", "start_range_m", "control_tracks", "control_uncovered_pct",
       "control_mean_risk", "control_worst_component", "adaptive_tracks", "adaptive_uncovered_pct",
       "adaptive_mean_risk", "adaptive_worst_component"},
      kTrueRanges.size() * kStarts,
      [&](std::size_t cell) { return study_cell(c, cell, kStarts); }};
  const auto rows = run_watched(s, c.output);
  Chart chart{"Track spacing: worst component of the residual risk (dashed: control)",
              "range believed at the start, m",
              "",
              {}};
  for (std::size_t r = 0; r < kTrueRanges.size(); ++r) {
    for (const bool adapt : {true, false}) {
      ChartCurve curve{adapt ? fmt::format("true {:g} m", kTrueRanges[r]) : "", {}, {}, !adapt};
      for (std::size_t k = 0; k < kStarts; ++k) {
        curve.x.push_back(rows[r * kStarts + k][1]);
        curve.y.push_back(rows[r * kStarts + k][adapt ? 9 : 5]);
      }
      chart.curves.push_back(std::move(curve));
    }
  }
  write_chart_png(c.output.folder / "spacing.png", chart);
  if (c.output.quiet) return;
  fmt::print(
      "true  start | control: tracks  uncovered %  worst | adaptive: tracks  uncovered %  "
      "worst\n");
  for (const auto& r : rows) {
    fmt::print("{:4g}  {:5g} | {:15.2f}  {:11.2f}  {:.3f} | {:16.2f}  {:11.2f}  {:.3f}\n", r[0],
               r[1], r[2], r[3], r[5], r[6], r[7], r[9]);
  }
}

void live(const SpacingCommand& c) {
  TrackSpacingOptions o = planner_of(c);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  o.port_looks_back = port_looks_back(box, {0, 0.0, true});
  TrackSpacingState state = start_spacing(o);
  LivePlanner planner{"spacing", [&] { return next_track(state); }, {}, {}};
  planner.observe = [&](const SurveyTrack& track, const nlohmann::json& message) {
    state = observe(state, track, observed_curves(message));
  };
  planner.figures = [&] {
    return nlohmann::ordered_json{{"good_range_m", state.good_range_m},
                                  {"range_too_short", state.range_too_short},
                                  {"uncovered_pct", 100.0 * uncovered_m(state) / o.width_m}};
  };
  const auto sailed = run_live(std::cin, std::cout, box, {}, planner);
  if (sailed.empty()) return;
  MissionOutput out = mission_output(box, sailed, o.range_m, flat_depth_m(o.range_m),
                                     provenance(c, o, "live", false));
  out.planner = "spacing";
  out.label = "Track spacing (live)";
  out.figures = {{"tracks", static_cast<double>(sailed.size())},
                 {"uncovered_pct", 100.0 * uncovered_m(state) / o.width_m}};
  out.pictures = {picture_of(out.label, o, sailed)};
  write_live_mission(c.output, out, box, o.range_m);
}

}  // namespace

Command adapt_spacing_command() {
  auto c = std::make_shared<SpacingCommand>();
  return {"spacing",
          "Paired tracks whose spacing follows the range of good data",
          {},
          {},
          {adapt_mode("simulate", "One mission and its residual risk",
                      joined({planner_options(*c), world_options(*c), mission_options(*c)}),
                      c->output, [c] { simulate(*c); }),
           adapt_mode("study", "Control against adaptive over believed and true ranges",
                      // A study has ranges of its own, and its box lies nowhere.
                      joined({without(planner_options(*c),
                                      {"--range", "--start-corner", "--azimuth", "--corner"}),
                              world_options(*c),
                              {missions_option(c->missions, "Per cell")}}),
                      c->output, [c] { study(*c); }),
           adapt_mode("live", "JSON lines: observations in, tracks out", planner_options(*c),
                      c->output, [c] { live(*c); })}};
}

}  // namespace swathplan

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include "apps/adapt/adapt_common.h"
#include "apps/adapt/adapt_live.h"
#include "apps/adapt/adapt_planners.h"
#include "io/results/adaptive_study.h"
#include "mesh/base/error.h"
#include "mesh/base/random.h"
#include "planners/adaptive/quality_baselines.h"

namespace swathplan {
namespace {

struct QualityCommand {
  BoxOptions box;
  AdaptOutput output;
  SiteOptions site;  ///< its no-go polygons alone
  QualitySurveyOptions planner;
  std::string constraint = "strong";
  double port_m = 70.0, starboard_m = 70.0;
  double failing = 0.1;
  int missions = 20;
};

constexpr std::array<GapConstraint, 3> kConstraints{GapConstraint::none, GapConstraint::mild,
                                                    GapConstraint::strong};

QualitySurveyOptions planner_of(const QualityCommand& c, const SurveyBox& box) {
  QualitySurveyOptions options = c.planner;
  const auto constraint = gap_constraint(c.constraint);
  if (!constraint) throw UsageError("constraint", c.constraint, "must be none, mild or strong");
  options.constraint = *constraint;
  options.port_looks_back = port_looks_back(box, {0, 0.0, true});
  check(options);
  return options;
}

OptionTable planner_options(QualityCommand& c) {
  return joined({{real("--width", "", c.planner.width_m, kMetres, any_number(),
                       "Of the area across the tracks, m", "width_m"),
                  real("--length", "", c.planner.length_m, kMetres, any_number(), "Of a track, m",
                       "length_m"),
                  real("--swath", "", c.planner.swath_m, kMetres, any_number(),
                       "Width of a swath, m", "swath_m"),
                  real("--range-min", "", c.planner.range_min_m, kMetres, any_number(),
                       "Nominal, m", "range_min_m"),
                  real("--range-max", "", c.planner.range_max_m, kMetres, any_number(),
                       "Nominal, m", "range_max_m"),
                  real("--quality", "", c.planner.quality, kNoUnit, any_number(),
                       "Correlation from which data is good", "quality"),
                  real("--cost-weight", "", c.planner.cost_weight, kNoUnit, any_number(),
                       "Of transit against swaths gained", "cost_weight"),
                  real("--turn-width", "", c.planner.turn_width_m, kMetres, any_number(),
                       "Twice the turning radius, m", "turn_width_m"),
                  choice("--constraint", "", c.constraint, {"none", "mild", "strong"},
                         "On the gaps that a track may leave", "constraint")},
                 box_options(c.box),
                 adapt_output_options(c.output)});
}

OptionTable world_options(QualityCommand& c) {
  return {real("--true-port", "", c.port_m, kMetres, at_least(0.0),
               "True range of the port side, m; 0: dead", "true_port_range_m"),
          real("--true-starboard", "", c.starboard_m, kMetres, at_least(0.0),
               "Of the starboard side, m; 0: dead", "true_starboard_range_m"),
          no_go_option(c.site.no_go)};
}

constexpr const char* kNothingGained =
    "the survey ended before all was covered: track after track gave no good data where it was "
    "missing";

Provenance provenance(const QualityCommand& c, const std::string& mode, bool with_world) {
  QualityCommand typed = c;
  OptionTable rows = planner_options(typed);
  if (with_world) rows = joined({std::move(rows), world_options(typed)});
  return adapt_provenance("adapt quality " + mode, rows, rows);
}

TrackPicture picture_of(const std::string& title, const QualitySurveyOptions& o,
                        const std::vector<SurveyTrack>& tracks, const std::vector<char>& covered) {
  TrackPicture picture{title, o.width_m, o.length_m, tracks, {}, "", {}};
  const bool gaps = std::find(covered.begin(), covered.end(), 0) != covered.end();
  picture.shade_label = gaps ? "dark: not covered" : "all covered";
  for (const char c : covered) picture.shade.push_back(c ? 0.0 : 0.6);
  return picture;
}

void simulate(const QualityCommand& c) {
  const SurveyBox box = box_of(c.box, c.planner.width_m, c.planner.length_m, {});
  const QualitySurveyOptions o = planner_of(c, box);
  const TrueQuality truth = true_quality(o, c.port_m, c.starboard_m);
  const QualitySurveyState state = sail(o, truth);
  const QualitySurveyState preplanned = sail_preplanned(o, truth);
  std::optional<std::vector<SurveyTrack>> optimum;
  if (optimum_known(o)) optimum = fewest_tracks(o, truth);
  MissionOutput out = mission_output(box, state.sailed, o.range_max_m, flat_depth_m(o.range_max_m),
                                     provenance(c, "simulate", true));
  out.planner = "quality";
  out.label = fmt::format("Quality survey ({} constraint)", c.constraint);
  out.figures = {{"tracks", static_cast<double>(state.sailed.size())},
                 {"covered_pct", 100.0 * covered_share(state)},
                 {"travel_m", travel_m(state.sailed, o.length_m)},
                 {"preplanned_tracks", static_cast<double>(preplanned.sailed.size())},
                 {"preplanned_covered_pct", 100.0 * covered_share(preplanned)}};
  if (optimum) {
    out.figures.insert(out.figures.begin() + 3,
                       {"optimal_tracks", static_cast<double>(optimum->size())});
  } else {
    out.notes.push_back("swaths are too narrow for the exact optimum: it is not among the figures");
  }
  if (optimum && optimum->empty()) {
    out.notes.push_back("no set of tracks covers the area with this sonar");
  }
  if (nothing_gained(state)) out.notes.push_back(kNothingGained);
  out.pictures = {picture_of("Pre-planned pairs", o, preplanned.sailed, preplanned.covered)};
  for (const GapConstraint constraint : kConstraints) {
    QualitySurveyOptions variant = o;
    variant.constraint = constraint;
    const auto s = sail(variant, truth);
    out.pictures.push_back(picture_of(
        fmt::format("{} constraint: {} tracks",
                    constraint == GapConstraint::none ? "no" : name(constraint), s.sailed.size()),
        o, s.sailed, s.covered));
  }
  keep_out_of(abstract_no_go(c.site, box, o.range_max_m, out), {}, out);
  write_flat_mission(c.output, out, box, o.range_max_m);
}

// A track on which a bin fails at random; what is good at all follows the true ranges.
QualityObservation noisy(const TrueQuality& truth, double failing, SeededNumbers& numbers) {
  QualityObservation observation = observe_world(truth);
  for (auto* side : {&observation.port, &observation.starboard}) {
    for (double& v : *side) {
      if (numbers.uniform() < failing) v = 0.0;
    }
  }
  return observation;
}

std::vector<double> study_cell(const QualityCommand& c, const QualitySurveyOptions& base,
                               std::size_t cell) {
  const int steps = range_bins(base);
  const bool dead = cell >= static_cast<std::size_t>(steps);
  const double range =
      base.range_min_m +
      base.swath_m * static_cast<double>(cell % static_cast<std::size_t>(steps) + 1);
  const TrueQuality truth = true_quality(base, range, dead ? 0.0 : range);
  std::vector<double> row{range, dead ? 0.0 : range};
  if (optimum_known(base)) row.push_back(static_cast<double>(fewest_tracks(base, truth).size()));
  row.push_back(100.0 * covered_share(sail_preplanned(base, truth)));
  for (const GapConstraint constraint : kConstraints) {
    QualitySurveyOptions o = base;
    o.constraint = constraint;
    const auto sure = sail(o, truth);
    double tracks = 0.0;
    for (int i = 0; i < c.missions; ++i) {
      SeededNumbers numbers(mixed_seed(c.output.seed, cell, static_cast<std::uint64_t>(i)));
      QualitySurveyState state = start_survey(o);
      while (const auto track = next_track(state)) {
        state = observe(std::move(state), *track, noisy(truth, c.failing, numbers));
      }
      tracks += static_cast<double>(state.sailed.size()) / c.missions;
    }
    row.insert(row.end(), {static_cast<double>(sure.sailed.size()),
                           travel_m(sure.sailed, o.length_m), 100.0 * covered_share(sure), tracks});
  }
  return row;
}

// What the optimum needs is a wide curve; what a variant needs beyond it tells them apart.
// Without an optimum the tracks themselves are drawn.
Chart study_chart(const std::vector<std::vector<double>>& rows, std::size_t bins, bool optimum) {
  Chart chart{optimum ? "Quality survey: tracks beyond the exact optimum, both sides alike"
                      : "Quality survey: tracks, both sides alike",
              "true range of good data, m",
              "",
              {}};
  const std::array<std::pair<const char*, std::size_t>, 3> curves{
      {{"no constraint", 4}, {"mild", 8}, {"strong", 12}}};
  for (const auto& [label, column] : curves) {
    ChartCurve curve{label, {}, {}, false};
    for (std::size_t i = 0; i < bins; ++i) {
      if (optimum && rows[i][2] == 0.0) continue;
      curve.x.push_back(rows[i][0]);
      curve.y.push_back(optimum ? rows[i][column] - rows[i][2] : rows[i][column - 1]);
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

void study(const QualityCommand& c) {
  const QualitySurveyOptions o = planner_of(c, SurveyBox{});
  const auto limit = thread_limit(c.output);
  const auto bins = static_cast<std::size_t>(range_bins(o));
  Study s{"quality",
          fmt::format("seed {} missions {} failing {} width_m {} length_m {} swath_m {} range_m {} "
                      "to {} cost_weight {} turn_width_m {}",
                      c.output.seed, c.missions, c.failing, o.width_m, o.length_m, o.swath_m,
                      o.range_min_m, o.range_max_m, o.cost_weight, o.turn_width_m),
          {"port_range_m", "starboard_range_m"},
          2 * bins,
          [&](std::size_t cell) { return study_cell(c, o, cell); }};
  const bool optimum = optimum_known(o);
  if (optimum) s.columns.emplace_back("optimal_tracks");
  s.columns.emplace_back("preplanned_covered_pct");
  for (const GapConstraint constraint : kConstraints) {
    const std::string n(name(constraint));
    s.columns.insert(s.columns.end(),
                     {n + "_tracks", n + "_travel_m", n + "_covered_pct", n + "_noisy_tracks"});
  }
  const auto rows = run_watched(s, c.output);
  write_chart_png(c.output.folder / "quality.png", study_chart(rows, bins, optimum));
  if (c.output.quiet) return;
  if (!optimum) {
    fmt::print(stderr, "note: swaths are too narrow for the exact optimum: it is left out\n");
  }
  fmt::print(
      "port starboard optimum preplanned % |  tracks none mild strong | travel km none mild "
      "strong | noisy tracks none mild strong\n");
  for (std::vector<double> r : rows) {
    const std::string fewest = optimum ? fmt::format("{:g}", r[2]) : "-";
    if (!optimum) r.insert(r.begin() + 2, 0.0);  // the other columns keep their places
    fmt::print(
        "{:4g} {:9g} {:>7} {:12.1f} | {:12g} {:4g} {:6g} | {:14.1f} {:5.1f} {:6.1f} | {:17.1f} "
        "{:4.1f} {:6.1f}\n",
        r[0], r[1], fewest, r[3], r[4], r[8], r[12], r[5] / 1e3, r[9] / 1e3, r[13] / 1e3, r[7],
        r[11], r[15]);
  }
}

// How a finished survey ended.
const char* status_of(const QualitySurveyState& state) {
  if (covered_share(state) >= 1.0) return "covered";
  return nothing_gained(state) ? "nothing gained" : "no track can cover more";
}

void live(const QualityCommand& c) {
  const SurveyBox box = box_of(c.box, c.planner.width_m, c.planner.length_m, {});
  const QualitySurveyOptions o = planner_of(c, box);
  QualitySurveyState state = start_survey(o);
  LivePlanner planner{"quality", [&] { return next_track(state); }, {}, {}};
  planner.observe = [&](const SurveyTrack& track, const nlohmann::json& message) {
    state = observe(state, track,
                    {message.at("port").get<std::vector<double>>(),
                     message.at("starboard").get<std::vector<double>>()});
  };
  planner.figures = [&] {
    return nlohmann::ordered_json{{"covered_pct", 100.0 * covered_share(state)},
                                  {"status", status_of(state)}};
  };
  const auto sailed = run_live(std::cin, std::cout, box, {}, planner);
  if (sailed.empty()) return;
  MissionOutput out = mission_output(box, sailed, o.range_max_m, flat_depth_m(o.range_max_m),
                                     provenance(c, "live", false));
  out.planner = "quality";
  out.label = "Quality survey (live)";
  out.figures = {{"tracks", static_cast<double>(sailed.size())},
                 {"covered_pct", 100.0 * covered_share(state)}};
  if (nothing_gained(state)) out.notes.push_back(kNothingGained);
  out.pictures = {picture_of(out.label, o, sailed, state.covered)};
  write_live_mission(c.output, out, box, o.range_max_m);
}

}  // namespace

Command adapt_quality_command() {
  auto c = std::make_shared<QualityCommand>();
  return {"quality",
          "Tracks chosen one by one from where the sonar has given good data",
          {},
          {},
          {adapt_mode("simulate", "One mission with fixed true ranges",
                      joined({planner_options(*c), world_options(*c)}), c->output,
                      [c] { simulate(*c); }),
           adapt_mode("study", "All true ranges, both sides and port alone",
                      // A study compares all constraints, and its box lies nowhere.
                      joined({without(planner_options(*c),
                                      {"--constraint", "--start-corner", "--azimuth", "--corner"}),
                              {missions_option(c->missions, "With random failures, per cell"),
                               real("--failing", "", c->failing, kNoUnit, within(0.0, 0.9),
                                    "Share of range bins that fail by chance", "failing")}}),
                      c->output, [c] { study(*c); }),
           adapt_mode("live", "JSON lines: observations in, tracks out", planner_options(*c),
                      c->output, [c] { live(*c); })}};
}

}  // namespace swathplan

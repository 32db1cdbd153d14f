// Monte Carlo of the accordion in abstract worlds, with the settings of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/adapt/adapt_accordion.h"
#include "io/files/atomic_file.h"
#include "io/results/adaptive_study.h"
#include "mesh/base/random.h"
#include "planners/adaptive/simulated_strips.h"

namespace swathplan {
namespace {

constexpr std::array<double, 7> kAlphas{0.01, 0.1, 0.25, 0.5, 0.75, 1.0, 2.0};
constexpr std::array<double, 7> kAreasKm2{5.5, 3.8, 3.3, 2.73, 2.34, 2.05, 1.36};
constexpr int kShares = 21;

// One cell: a hundred missions with one alpha and one share of strips with objects.
std::vector<double> study_cell(const AccordionCommand& c, const AccordionOptions& base,
                               std::size_t cell) {
  const std::size_t a = cell / kShares;
  const double share = static_cast<double>(cell % kShares) / (kShares - 1);
  AccordionOptions o = base;
  o.length_m = o.spacing_m / kAlphas[a];
  o.width_m =
      o.spacing_m * std::max(1.0, std::round(kAreasKm2[a] * 1e6 / o.length_m / o.spacing_m));
  const double lawnmower =
      mission_length_m(overlapping_lawnmower(o.width_m, o.spacing_m), o.length_m);
  double sum = 0.0, periods = 0.0, worst = -1e300, excess = -1e300;
  int better = 0, unseen = 0;
  for (int i = 0; i < c.missions; ++i) {
    const auto world =
        random_strips(o.width_m, o.spacing_m, share,
                      mixed_seed(c.output.seed, cell, static_cast<std::uint64_t>(i)));
    const auto mission = sail(world, o);
    const auto g = gain(mission.state);
    sum += g.whole_pct;
    periods += g.periods_pct;
    worst = std::max(worst, -g.whole_pct);
    excess = std::max(excess, (mission.state.sailed_m - lawnmower) / (o.length_m + o.spacing_m));
    better += g.whole_pct > 1e-9 ? 1 : 0;
    unseen += mission.objects - mission.objects_seen_twice;
  }
  return {kAlphas[a],
          100.0 * share,
          o.width_m,
          o.length_m,
          sum / c.missions,
          periods / c.missions,
          published_improvement_pct(kAlphas[a], 100.0 * share),
          -worst,
          excess,
          100.0 * better / c.missions,
          static_cast<double>(unseen)};
}

std::string study_summary(const std::vector<std::vector<double>>& rows) {
  double squares = 0.0;
  double unseen = 0.0;
  for (const auto& r : rows) {
    squares += (r[4] - r[6]) * (r[4] - r[6]);
    unseen += r[10];
  }
  std::string text = fmt::format(
      "RMS difference from the published function: {:.2f} points; objects "
      "not seen from both sides: {:g}\n",
      std::sqrt(squares / static_cast<double>(rows.size())), unseen);
  text +=
      "alpha   mean %  break-even p_obj %  shorter % (p_obj to 100, 90, 80)  worst, tracks over\n";
  for (std::size_t a = 0; a < kAlphas.size(); ++a) {
    double mean = 0.0, worst = -1e300, even = 100.0;
    std::array<double, kShares> shorter{};
    for (int k = 0; k < kShares; ++k) {
      const auto& r = rows[a * kShares + static_cast<std::size_t>(k)];
      mean += r[4] / kShares;
      worst = std::max(worst, r[8]);
      shorter[static_cast<std::size_t>(k)] = r[9];
      if (k == 0 || even < 100.0 || r[4] >= 0.0) continue;
      const auto& before = rows[a * kShares + static_cast<std::size_t>(k) - 1];
      even = before[1] + (r[1] - before[1]) * before[4] / (before[4] - r[4]);
    }
    const auto upto = [&](int last) {
      double sum = 0.0;
      for (int k = 0; k <= last; ++k) sum += shorter[static_cast<std::size_t>(k)];
      return sum / (last + 1);
    };
    text +=
        fmt::format("{:<7g} {:6.2f}  {:18.1f}  {:6.1f} {:6.1f} {:6.1f}                {:10.2f}\n",
                    kAlphas[a], mean, even, upto(20), upto(18), upto(16), worst);
  }
  return text;
}

Chart study_chart(const std::string& rule, const std::vector<std::vector<double>>& rows) {
  Chart chart{
      fmt::format("Accordion ({}): improvement on the lawnmower, % (dashed: published)", rule),
      "strips with objects, %",
      "",
      {}};
  for (std::size_t a = 0; a < kAlphas.size(); ++a) {
    ChartCurve ours{fmt::format("alpha {:g}", kAlphas[a]), {}, {}, false};
    ChartCurve published{"", {}, {}, true};
    for (int k = 0; k < kShares; ++k) {
      const auto& r = rows[a * kShares + static_cast<std::size_t>(k)];
      ours.x.push_back(r[1]);
      ours.y.push_back(r[4]);
      published.x.push_back(r[1]);
      published.y.push_back(r[6]);
    }
    chart.curves.push_back(std::move(ours));
    chart.curves.push_back(std::move(published));
  }
  return chart;
}

}  // namespace

void study_accordion(const AccordionCommand& c) {
  const AccordionOptions base = accordion_of(c, kWorldThreshold);
  const auto limit = thread_limit(c.output);
  Study s{
      fmt::format("accordion-{}", c.rule),
      fmt::format("seed {} missions {} spacing_m {} nadir_gap_m {} clearance_m {}", c.output.seed,
                  c.missions, base.spacing_m, base.nadir_gap_m, base.clearance_m),
      {"alpha", "p_obj_pct", "width_m", "length_m", "mean_improvement_pct",
       "mean_improvement_periods_pct", "published_improvement_pct", "worst_improvement_pct",
       "worst_excess_tracks", "shorter_pct", "objects_not_seen_twice"},
      kAlphas.size() * kShares,
      [&](std::size_t cell) { return study_cell(c, base, cell); }};
  const auto rows = run_watched(s, c.output);
  write_chart_png(c.output.folder / (s.name + ".png"), study_chart(c.rule, rows));
  const std::string summary = study_summary(rows);
  write_text_atomically(c.output.folder / (s.name + ".txt"), summary);
  if (!c.output.quiet) fmt::print("{}", summary);
}

}  // namespace swathplan

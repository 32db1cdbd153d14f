#include "planners/adaptive/quality_survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/base/error.h"
#include "mesh/base/require.h"
#include "planners/adaptive/quality_swaths_internal.h"

namespace swathplan {
namespace {

constexpr std::array<std::pair<GapConstraint, std::string_view>, 3> kNames{{
    {GapConstraint::none, "none"},
    {GapConstraint::mild, "mild"},
    {GapConstraint::strong, "strong"},
}};

// Rates are ratios of small integers, so rates closer than this are equal.
constexpr double kSameRate = 1e-9;
// A survey ends after this many tracks in a row without a new swath. After the second of them each
// range bin is judged anew, so a sonar that still works has covered something long before.
constexpr std::size_t kVainInARow = 8;
// One vain track may be bad luck. From so many in a row on, the past is no guide any more.
constexpr std::size_t kVainToChange = 2;
// So often may such tracks take the same line in one direction.
constexpr std::ptrdiff_t kVainOnALine = 2;

double required_probability(GapConstraint constraint) {
  return constraint == GapConstraint::strong ? 0.5 : 0.0;
}

struct Candidate {
  double across_m = 0.0, benefit = 0.0, gap_probability = 0.0;
};

// Expected new swaths of a track, and its chance of covering the first uncovered one.
Candidate assess(const QualitySurveyState& state, double across_m, bool outbound, int gap,
                 const SideRates& rates) {
  Candidate result{across_m, 0.0, 0.0};
  for (const bool back : {true, false}) {
    const bool port = back == (outbound == state.options.port_looks_back);
    const std::vector<double>& rate = port ? rates.port : rates.starboard;
    for (int bin = 0; bin < static_cast<int>(rate.size()); ++bin) {
      const int swath = swath_at(state.options, across_m, back, bin);
      if (swath < 0 || swath >= static_cast<int>(state.covered.size())) continue;
      if (state.covered[static_cast<std::size_t>(swath)]) continue;
      result.benefit += rate[static_cast<std::size_t>(bin)];
      if (swath == gap) result.gap_probability = rate[static_cast<std::size_t>(bin)];
    }
  }
  return result;
}

SideRates rates_of(const QualitySurveyState& state) {
  SideRates rates;
  for (int bin = 0; bin < range_bins(state.options); ++bin) {
    rates.port.push_back(success_rate(state, true, bin));
    rates.starboard.push_back(success_rate(state, false, bin));
  }
  return rates;
}

bool tried_enough(const QualitySurveyState& state, double across_m, bool outbound) {
  return std::count_if(state.vain.begin(), state.vain.end(), [&](const SurveyTrack& t) {
           return t.outbound == outbound && std::abs(t.across_m - across_m) < 1e-6;
         }) >= kVainOnALine;
}

std::vector<Candidate> candidates(const QualitySurveyState& state, bool outbound, int gap) {
  const SideRates rates = rates_of(state);
  std::vector<Candidate> result;
  for (int i = 0; i <= static_cast<int>(state.covered.size()); ++i) {
    const Candidate c = assess(state, i * state.options.swath_m, outbound, gap, rates);
    if (c.benefit > 0.0 && !tried_enough(state, c.across_m, outbound)) result.push_back(c);
  }
  return result;
}

void keep_allowed(std::vector<Candidate>& list, GapConstraint constraint) {
  if (constraint == GapConstraint::none) return;
  double best = 0.0;
  for (const Candidate& c : list) best = std::max(best, c.gap_probability);
  const double required = required_probability(constraint);
  const bool met = best > required + kSameRate;
  std::erase_if(list, [&](const Candidate& c) {
    return met ? c.gap_probability <= required + kSameRate : c.gap_probability < best - kSameRate;
  });
}

void check_side(const std::vector<double>& side, std::size_t bins, int track, const char* name) {
  if (side.size() != bins) {
    throw InvalidInput(
        fmt::format("track {}: {} correlations on the {} side; give {}, one for "
                    "each range bin",
                    track, side.size(), name, bins));
  }
  for (std::size_t i = 0; i < bins; ++i) {
    if (!(side[i] >= -1.0 && side[i] <= 1.0)) {
      throw InvalidInput(
          fmt::format("track {}: correlation {} of the {} side is {}; must lie in "
                      "[-1, 1]",
                      track, i, name, side[i]));
    }
  }
}

void note_side(QualitySurveyState& state, const SurveyTrack& track, bool port,
               const std::vector<double>& correlation) {
  const QualitySurveyOptions& o = state.options;
  const bool back = port == (track.outbound == o.port_looks_back);
  std::vector<int>& good = port ? state.good_port : state.good_starboard;
  for (int& counted : port ? state.counted_port : state.counted_starboard) ++counted;
  for (int bin = 0; bin < static_cast<int>(correlation.size()); ++bin) {
    if (correlation[static_cast<std::size_t>(bin)] < o.quality) continue;
    ++good[static_cast<std::size_t>(bin)];
    const int swath = swath_at(o, track.across_m, back, bin);
    if (swath >= 0 && swath < static_cast<int>(state.covered.size())) {
      state.covered[static_cast<std::size_t>(swath)] = 1;
    }
  }
}

// Bins that were thought good and failed now are counted from this track on.
void doubt_failures(QualitySurveyState& state, bool port, const std::vector<double>& correlation) {
  std::vector<int>& good = port ? state.good_port : state.good_starboard;
  std::vector<int>& counted = port ? state.counted_port : state.counted_starboard;
  for (std::size_t bin = 0; bin < correlation.size(); ++bin) {
    const bool thought_good = 3 * (good[bin] + 1) > counted[bin] + 2;  // above one of one failed
    if (correlation[bin] >= state.options.quality || !thought_good) continue;
    good[bin] = 0;
    counted[bin] = 1;
  }
}

bool is_multiple(double value, double of) {
  return std::abs(value / of - std::round(value / of)) < 1e-6;
}

}  // namespace

std::optional<GapConstraint> gap_constraint(std::string_view text) {
  for (const auto& [constraint, known] : kNames) {
    if (known == text) return constraint;
  }
  return std::nullopt;
}

std::string_view name(GapConstraint constraint) {
  for (const auto& [known, text] : kNames) {
    if (known == constraint) return text;
  }
  return "none";
}

void check(const QualitySurveyOptions& o) {
  require_positive("swath", o.swath_m);
  require_positive("width", o.width_m);
  require_positive("length", o.length_m);
  require_positive("turn width (twice the turning radius)", o.turn_width_m);
  require(is_multiple(o.width_m, o.swath_m), "width", o.width_m, "a multiple of the swath");
  require(o.range_min_m >= 0.0 && is_multiple(o.range_min_m, o.swath_m), "smallest range",
          o.range_min_m, "a multiple of the swath, at least 0");
  require(o.range_max_m > o.range_min_m && is_multiple(o.range_max_m, o.swath_m), "largest range",
          o.range_max_m, "a multiple of the swath, above the smallest range");
  require(o.width_m >= o.range_max_m, "width", o.width_m,
          "at least the largest range: the area is narrower than a track's side");
  require(o.quality > 0.0 && o.quality < 1.0, "quality", o.quality, "inside (0, 1)");
  require(o.cost_weight >= 0.0 && std::isfinite(o.cost_weight), "cost weight", o.cost_weight,
          "a finite number of at least 0");
}

int range_bins(const QualitySurveyOptions& o) {
  return static_cast<int>(std::lround((o.range_max_m - o.range_min_m) / o.swath_m));
}

QualitySurveyState start_survey(const QualitySurveyOptions& options) {
  check(options);
  QualitySurveyState state;
  state.options = options;
  const auto bins = static_cast<std::size_t>(range_bins(options));
  state.covered.assign(static_cast<std::size_t>(swath_count(options)), 0);
  state.good_port.assign(bins, 0);
  state.good_starboard.assign(bins, 0);
  state.counted_port.assign(bins, 0);
  state.counted_starboard.assign(bins, 0);
  return state;
}

double success_rate(const QualitySurveyState& state, bool port, int bin) {
  const auto i = static_cast<std::size_t>(bin);
  const int good = port ? state.good_port[i] : state.good_starboard[i];
  const int counted = port ? state.counted_port[i] : state.counted_starboard[i];
  return (good + 1.0) / (counted + 2.0);
}

double transit_cost(const QualitySurveyOptions& options, double from_m, double to_m) {
  const double d = std::abs(to_m - from_m) / options.turn_width_m;
  return (d - 1.0) * (d - 1.0);
}

double covered_share(const QualitySurveyState& state) {
  const auto count = std::count(state.covered.begin(), state.covered.end(), 1);
  return static_cast<double>(count) / static_cast<double>(state.covered.size());
}

bool nothing_gained(const QualitySurveyState& state) { return state.vain.size() >= kVainInARow; }

std::optional<SurveyTrack> next_track(const QualitySurveyState& state) {
  const auto gap = std::find(state.covered.begin(), state.covered.end(), 0);
  if (gap == state.covered.end()) return std::nullopt;
  if (nothing_gained(state)) return std::nullopt;
  const int number = static_cast<int>(state.sailed.size());
  const bool outbound = number % 2 == 0;
  auto list = candidates(state, outbound, static_cast<int>(gap - state.covered.begin()));
  keep_allowed(
      list, state.vain.size() >= kVainToChange ? GapConstraint::strong : state.options.constraint);
  std::optional<SurveyTrack> best;
  double best_utility = 0.0;
  for (const Candidate& c : list) {
    // The first track may be anywhere: the vehicle has not started yet.
    const double cost = state.sailed.empty()
                            ? 0.0
                            : transit_cost(state.options, state.sailed.back().across_m, c.across_m);
    const double utility = c.benefit - state.options.cost_weight * cost;
    if (best && utility <= best_utility + kSameRate) continue;
    best = SurveyTrack{number, c.across_m, outbound};
    best_utility = utility;
  }
  return best;
}

QualitySurveyState observe(QualitySurveyState state, const SurveyTrack& track,
                           const QualityObservation& observation) {
  check_due(track, next_track(state));
  const auto bins = static_cast<std::size_t>(range_bins(state.options));
  check_side(observation.port, bins, track.number, "port");
  check_side(observation.starboard, bins, track.number, "starboard");
  const auto before = std::count(state.covered.begin(), state.covered.end(), 1);
  note_side(state, track, true, observation.port);
  note_side(state, track, false, observation.starboard);
  state.sailed.push_back(track);
  if (std::count(state.covered.begin(), state.covered.end(), 1) > before) {
    state.vain.clear();
    return state;
  }
  state.vain.push_back(track);
  if (state.vain.size() != kVainToChange) return state;
  doubt_failures(state, true, observation.port);
  doubt_failures(state, false, observation.starboard);
  return state;
}

}  // namespace swathplan

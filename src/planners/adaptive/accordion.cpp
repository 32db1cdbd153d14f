#include "planners/adaptive/accordion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/base/error.h"
#include "mesh/base/require.h"
#include "planners/adaptive/accordion_bounded_internal.h"

namespace swathplan {
namespace {

constexpr double kSamePlace = 1e-6;  // tracks nearer than a micrometre are one track
// Pings do not begin and end exactly with the track.
constexpr double kLengthSlack = 0.05;  // of a track
constexpr double kShortSlack = 1.0;    // of a track that is only a few pings long
constexpr double kLastPixel = 0.2;

// Earlier tracks need no look: before a skip and its loop all tracks lie closer to the start.
bool was_sailed(const AccordionState& state, double across) {
  const auto first = state.sailed.size() > 6 ? state.sailed.end() - 6 : state.sailed.begin();
  return std::any_of(first, state.sailed.end(), [&](const SurveyTrack& t) {
    return std::abs(t.across_m - across) < kSamePlace;
  });
}

Interval looked_at_ahead(const AccordionOptions& o, double across) {
  return {across + o.nadir_gap_m, across + sonar_range_m(o)};
}
Interval looked_at_behind(const AccordionOptions& o, double across) {
  return {across - sonar_range_m(o), across - o.nadir_gap_m};
}

bool lies_in(const Interval& inner, const Interval& outer) {
  return inner.low >= outer.low - kSamePlace && inner.high <= outer.high + kSamePlace;
}

// Cases 1, 4 and the first half of 5, 6: something behind has been seen from the far side only.
std::optional<double> loop_back(const AccordionState& state) {
  const double back = std::max(0.0, state.front_m - state.options.spacing_m);
  if (was_sailed(state, back)) return std::nullopt;
  const Interval look = looked_at_ahead(state.options, back);
  const bool needed = std::any_of(state.pending.begin(), state.pending.end(), [&](const auto& o) {
    return !state.seen_from_below.covers(o) && o.high > look.low && o.low < look.high;
  });
  return needed ? std::optional(back) : std::nullopt;
}

// Whether a track at `next` lies too far for its look at an object ahead from the far side.
bool passes_over_object(const AccordionState& state, double next) {
  const Interval look = looked_at_behind(state.options, next);
  return std::any_of(state.pending.begin(), state.pending.end(), [&](const Interval& o) {
    return o.high > state.front_m - state.options.nadir_gap_m && !state.seen_from_above.covers(o) &&
           !lies_in(o, look);
  });
}

bool waits_ahead(const AccordionState& state) {
  return passes_over_object(state, std::numeric_limits<double>::infinity());
}

double basic_step(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const double two = std::min(state.front_m + 2.0 * o.spacing_m, o.width_m);
  const double one = std::min(state.front_m + o.spacing_m, o.width_m);
  return passes_over_object(state, two) ? one : two;
}

std::optional<double> next_across(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const bool bounded = o.rule == AccordionRule::bounded;
  if (state.sailed.empty()) return bounded ? bounded_start(state) : 0.0;
  if (const auto back = bounded ? bounded_loop_back(state) : loop_back(state)) return back;
  if (state.front_m >= o.width_m - kSamePlace) return std::nullopt;
  const bool all_seen = state.front_m + o.spacing_m >= o.width_m - kSamePlace;
  if (all_seen && !waits_ahead(state)) return std::nullopt;
  return bounded ? bounded_step(state) : basic_step(state);
}

void check_map(const CostMap& map, const AccordionOptions& o, int track, const char* side) {
  if (map.rows < 1 || map.columns < 1 || map.values.size() != map.index(map.rows, 0)) {
    throw InvalidInput(
        fmt::format("track {}: the {} cost map has {} values for {} rows x {} "
                    "columns; give rows x columns of them, at least one",
                    track, side, map.values.size(), map.rows, map.columns));
  }
  const double reach = map.first_m + map.columns * map.step_m;
  if (!(map.step_m > 0.0) || !(map.first_m >= 0.0) || !(reach >= 0.0)) {
    throw InvalidInput(fmt::format(
        "track {}: the {} cost map begins {} m from the track with columns of {} m; it must begin "
        "at 0 m or more, and columns must be wider than 0 m",
        track, side, map.first_m, map.step_m));
  }
  if (std::max(map.first_m, map.blind_m) > o.nadir_gap_m + kSamePlace) {
    throw InvalidInput(fmt::format(
        "track {}: the {} cost map begins {} m from the track, beyond the nadir gap of {} m; the "
        "strip next to the track would stay unseen",
        track, side, std::max(map.first_m, map.blind_m), o.nadir_gap_m));
  }
  // A pixel is a rounded share of the range, so that the last one may end a little short of it.
  const double needed = sonar_range_m(o);
  if (reach < needed - std::max(kSamePlace, std::min(map.step_m, kLastPixel))) {
    throw InvalidInput(fmt::format(
        "track {}: the {} cost map reaches {} m from the track; it must reach the sonar "
        "range (spacing + nadir gap) of {} m",
        track, side, reach, needed));
  }
  const double slack = std::max(kLengthSlack * o.length_m, kShortSlack);
  if (map.along_m != 0.0 && !(std::abs(map.along_m - o.length_m) <= slack)) {
    throw InvalidInput(
        fmt::format("track {}: the {} rows span {} m along the track; the track is {} m long",
                    track, side, map.along_m, o.length_m));
  }
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (!(map.values[i] >= 0.0F) || !std::isfinite(map.values[i])) {
      throw InvalidInput(
          fmt::format("track {}: cost {} of the {} side is {}; costs are finite "
                      "numbers of at least 0",
                      track, i, side, map.values[i]));
    }
  }
}

// Runs of columns with an object in any row, as distances from the track within the sonar range.
std::vector<Interval> object_runs(const CostMap& map, const AccordionOptions& o) {
  std::vector<Interval> runs;
  const double reach = sonar_range_m(o);
  bool open = false;
  for (int c = 0; c < map.columns; ++c) {
    const double low = map.first_m + c * map.step_m;
    if (low > reach - kSamePlace) break;
    bool hot = false;
    for (int r = 0; r < map.rows && !hot; ++r) {
      hot = map.values[map.index(r, c)] > o.threshold;
    }
    if (hot && !open) runs.push_back({low, low});
    if (hot) runs.back().high = std::min(low + map.step_m, reach);
    open = hot;
  }
  return runs;
}

void note_side(AccordionState& state, const SurveyTrack& track, const CostMap& map, double sign) {
  const AccordionOptions& o = state.options;
  const double edge = track.across_m + sign * o.spacing_m;
  const Interval strip{std::max(0.0, std::min(track.across_m, edge)),
                       std::min(o.width_m, std::max(track.across_m, edge))};
  if (strip.high - strip.low < kSamePlace) return;
  const bool fresh =
      state.seen_from_above.covered_m(strip) + state.seen_from_below.covered_m(strip) <
      0.5 * (strip.high - strip.low);
  const auto keep = [&](const Interval& run) {
    const double a = track.across_m + sign * run.low;
    const double b = track.across_m + sign * run.high;
    const Interval object{std::max(0.0, std::min(a, b)), std::min(o.width_m, std::max(a, b))};
    if (object.high - object.low < kSamePlace) return false;
    state.pending.push_back(object);
    return true;
  };
  bool any = false;
  for (const Interval& run : object_runs(map, o)) any = keep(run) || any;
  // Nobody knows what lies in a blind strip, so the neighbours look at it as at an object.
  const double blind = std::max(map.first_m, map.blind_m);
  if (blind > kSamePlace) any = keep({0.0, blind}) || any;
  if (!fresh) return;
  ++state.strips_seen;
  if (any) ++state.strips_with_objects;
}

// Drops the objects that were seen from both sides, and those that no further track can see.
void forget_finished(AccordionState& state) {
  const double behind = state.front_m - 2.0 * sonar_range_m(state.options);
  std::erase_if(state.pending, [&](const Interval& o) {
    return (state.seen_from_below.covers(o) && state.seen_from_above.covers(o)) || o.high < behind;
  });
}

}  // namespace

void check(const AccordionOptions& o) {
  require_positive("width", o.width_m);
  require_positive("length", o.length_m);
  require_positive("spacing", o.spacing_m);
  if (!(o.nadir_gap_m >= 0.0 && o.nadir_gap_m < o.spacing_m)) {
    throw UsageError("nadir gap", fmt::format("{} m", o.nadir_gap_m),
                     fmt::format("must lie in [0, spacing = {} m)", o.spacing_m));
  }
  if (!(o.clearance_m >= 0.0 && o.clearance_m < 0.5 * (o.spacing_m - o.nadir_gap_m))) {
    throw UsageError("clearance", fmt::format("{} m", o.clearance_m),
                     "must lie in [0, half of spacing - nadir gap)");
  }
  if (!(o.threshold >= 0.0) || !std::isfinite(o.threshold)) {
    throw UsageError("threshold", fmt::format("{}", o.threshold),
                     "must be a finite number of at least 0");
  }
}

double sonar_range_m(const AccordionOptions& options) {
  return options.spacing_m + options.nadir_gap_m;
}

AccordionState start_accordion(const AccordionOptions& options) {
  check(options);
  AccordionState state;
  state.options = options;
  return state;
}

std::optional<SurveyTrack> next_track(const AccordionState& state) {
  const auto across = next_across(state);
  if (!across) return std::nullopt;
  const int number = static_cast<int>(state.sailed.size());
  return SurveyTrack{number, *across, number % 2 == 0};
}

AccordionState observe(AccordionState state, const SurveyTrack& track,
                       const AccordionObservation& observation) {
  check_due(track, next_track(state));
  check_map(observation.back, state.options, track.number, "back");
  check_map(observation.ahead, state.options, track.number, "ahead");
  note_side(state, track, observation.back, -1.0);
  note_side(state, track, observation.ahead, 1.0);
  state.seen_from_above.add(looked_at_behind(state.options, track.across_m));
  state.seen_from_below.add(looked_at_ahead(state.options, track.across_m));
  const double here = state.sailed.empty() ? 0.0 : state.sailed.back().across_m;
  if (!state.sailed.empty() && track.across_m < state.front_m) {
    ++state.loops;
    state.loops_m += 2.0 * (state.front_m - track.across_m);
  }
  state.sailed_m += std::abs(track.across_m - here) + state.options.length_m;
  state.front_m = std::max(state.front_m, track.across_m);
  state.sailed.push_back(track);
  forget_finished(state);
  return state;
}

std::vector<SurveyTrack> overlapping_lawnmower(double width_m, double spacing_m) {
  std::vector<SurveyTrack> tracks;
  const int last = static_cast<int>(std::ceil(width_m / spacing_m - kSamePlace));
  for (int i = 0; i <= last; ++i) {
    tracks.push_back({i, std::min(i * spacing_m, width_m), i % 2 == 0});
  }
  return tracks;
}

double published_improvement_pct(double a, double p) {
  return 50.2 - 52.42 * a - 0.6427 * p + 34.86 * a * a - 0.09411 * a * p - 0.002369 * p * p -
         8.262 * a * a * a - 0.05325 * a * a * p + 0.00327 * a * p * p + 4.38e-05 * p * p * p;
}

}  // namespace swathplan

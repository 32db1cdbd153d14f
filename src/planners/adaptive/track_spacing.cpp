#include "planners/adaptive/track_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/base/error.h"
#include "mesh/base/require.h"

namespace swathplan {
namespace {

constexpr double kTouching = 1e-6;  // widths that differ by a micrometre are the same
// A narrower stripe is no more than the estimate of a range is uncertain, and is not worth a track.
constexpr double kLeastStripe = 5.0;
// A single track that covers less than this was in vain. Two of them show that no third will help.
constexpr double kLeastGain = 1.0;
constexpr int kVainRepairs = 2;

double pair_width_m(double range, double nadir) { return 3.0 * range - nadir; }
double single_width_m(double range, double nadir) { return range - nadir; }

// Width that `count` tracks of a plan cover.
double planned_width_m(int count, double range, double nadir) {
  const int pairs = count / 2;
  const int singles = count % 2;
  return pairs * pair_width_m(range, nadir) + singles * single_width_m(range, nadir);
}

// Decides the pair that starts at the edge: its range, whether it is a single track, its place.
void open_pair(TrackSpacingState& state) {
  const TrackSpacingOptions& o = state.options;
  const double rest = o.width_m - state.edge_m;
  state.in_pair = 0;
  state.spare_m = 0.0;
  if (rest < kTouching) return;
  state.range_m = o.adapt ? adapted_range_m(rest, state.good_range_m, o.nadir_m) : o.range_m;
  const int count = tracks_needed(rest, state.range_m, o.nadir_m);
  state.single = count == 1;
  if (o.careful && o.adapt && state.sailed.empty()) {
    state.spare_m = planned_width_m(count, state.range_m, o.nadir_m) - rest;
    // The edge must stay beyond the track's own nadir gap.
    state.spare_m = std::clamp(state.spare_m, 0.0, state.range_m - 3.0 * o.nadir_m);
  }
}

double first_of_pair_m(const TrackSpacingState& state) {
  return state.edge_m - state.spare_m + state.range_m;
}

// The range by which a pair's second track is laid.
double partner_range_m(const TrackSpacingState& state) {
  const TrackSpacingOptions& o = state.options;
  if (!o.adapt || !o.careful) return state.range_m;
  return std::clamp(state.good_range_m, 3.0 * o.nadir_m, state.range_m);
}

void close_pair(TrackSpacingState& state) {
  const TrackSpacingOptions& o = state.options;
  const double reach = o.adapt
                           ? std::min(state.range_m, std::max(state.good_range_m, 3.0 * o.nadir_m))
                           : state.range_m;
  state.edge_m = state.single ? o.width_m : state.sailed.back().across_m + reach;
  open_pair(state);
}

// What a track at `across_m` covers with the ranges of the last one.
void add_sides(IntervalSet& covered, const TrackSpacingState& state, double across_m,
               bool outbound) {
  const TrackSpacingOptions& o = state.options;
  const bool port_back = outbound == o.port_looks_back;
  const double back = port_back ? state.port_m : state.starboard_m;
  const double ahead = port_back ? state.starboard_m : state.port_m;
  covered.add({across_m - back, across_m - o.nadir_m});
  covered.add({across_m + o.nadir_m, across_m + ahead});
}

// The first stripe between `from` and `to` that nobody has covered.
std::optional<Interval> first_stripe(const IntervalSet& covered, double from, double to) {
  double at = from;
  while (at < to - kLeastStripe) {
    const double low = covered.run_end(at);
    const auto next = std::find_if(covered.stretches().begin(), covered.stretches().end(),
                                   [&](const Interval& s) { return s.low > low; });
    const double high = next == covered.stretches().end() ? to : std::min(next->low, to);
    if (high - low >= kLeastStripe) return Interval{low, high};
    at = std::max(high, at + kTouching);
  }
  return std::nullopt;
}

// The stripe that pairs have left; looked for between pairs only.
std::optional<Interval> open_stripe(const TrackSpacingState& state) {
  const TrackSpacingOptions& o = state.options;
  if (!o.adapt || !o.careful || state.sailed.empty() || state.in_pair != 0) return std::nullopt;
  return first_stripe(state.covered, state.given_up_m, std::min(state.edge_m, o.width_m));
}

// Where a single track covers most of the area anew, its one side or the other at the stripe.
// Empty where the sonar does not see beyond its own nadir gap.
std::optional<double> repair_m(const TrackSpacingState& state, const Interval& stripe,
                               bool outbound) {
  const TrackSpacingOptions& o = state.options;
  const bool port_back = outbound == o.port_looks_back;
  const double back = port_back ? state.port_m : state.starboard_m;
  std::optional<double> best;
  double most = kLeastGain;
  const Interval area{0.0, o.width_m};
  const double before = state.covered.covered_m(area);
  for (const double across : {stripe.low + back, stripe.low - o.nadir_m}) {
    IntervalSet after = state.covered;
    add_sides(after, state, across, outbound);
    const double gained = after.covered_m(area) - before;
    const bool closes = after.run_end(stripe.low) > stripe.low + kLeastGain;
    if (!closes || gained <= most + kTouching) continue;
    most = gained;
    best = across;
  }
  return best;
}

std::optional<SurveyTrack> repair_track(const TrackSpacingState& state) {
  const auto stripe = open_stripe(state);
  if (!stripe) return std::nullopt;
  const int number = static_cast<int>(state.sailed.size());
  const auto across = repair_m(state, *stripe, number % 2 == 0);
  if (!across) return std::nullopt;
  return SurveyTrack{number, *across, number % 2 == 0};
}

void close_repair(TrackSpacingState& state, const Interval& stripe) {
  const bool vain = state.covered.run_end(stripe.low) < stripe.low + kLeastGain;
  state.vain_repairs = vain ? state.vain_repairs + 1 : 0;
  if (state.vain_repairs >= kVainRepairs) {
    state.given_up_m = stripe.high;
    state.vain_repairs = 0;
  }
  if (state.edge_m > state.options.width_m - kTouching) return;
  state.edge_m = std::min(state.covered.run_end(state.edge_m), state.options.width_m);
  open_pair(state);
}

void learn(TrackSpacingState& state, const SurveyTrack& track, const SideCurves& curves) {
  const TrackSpacingOptions& o = state.options;
  state.port_m = admissible_range_m(curves.port, o.threshold).value_or(0.0);
  state.starboard_m = admissible_range_m(curves.starboard, o.threshold).value_or(0.0);
  add_sides(state.covered, state, track.across_m, track.outbound);
  if (!o.adapt) return;
  // A tenth of a millimetre of rounding must not cost a metre of range.
  const double range = std::floor(std::min(state.port_m, state.starboard_m) + 1e-4);
  state.range_too_short = state.range_too_short || range < 3.0 * o.nadir_m;
  state.good_range_m = std::max(range, 3.0 * o.nadir_m);
}

}  // namespace

void check(const TrackSpacingOptions& o) {
  require_positive("width", o.width_m);
  require_positive("length", o.length_m);
  require_positive("nadir gap r_n", o.nadir_m);
  require_positive("range r", o.range_m);
  if (o.range_m < 3.0 * o.nadir_m) {
    throw UsageError(
        fmt::format("range r = {} m with a nadir gap r_n = {} m; paired tracks close "
                    "their nadir gaps only with r >= 3 r_n = {} m",
                    o.range_m, o.nadir_m, 3.0 * o.nadir_m));
  }
  if (o.width_m < o.nadir_m) {
    throw UsageError(
        "width", fmt::format("{} m", o.width_m),
        fmt::format("the area is narrower than a track's nadir gap of {} m", o.nadir_m));
  }
  if (!(o.threshold > 0.0 && o.threshold < 1.0)) {
    throw UsageError("threshold", fmt::format("{}", o.threshold), "must lie in (0, 1)");
  }
}

int tracks_needed(double width_m, double range_m, double nadir_m) {
  if (width_m < kTouching) return 0;
  const double pair = pair_width_m(range_m, nadir_m);
  const int pairs = static_cast<int>(std::floor(width_m / pair + kTouching));
  const double rest = width_m - pairs * pair;
  if (rest < kTouching * pair) return 2 * pairs;
  return 2 * pairs + (rest <= single_width_m(range_m, nadir_m) + kTouching ? 1 : 2);
}

double adapted_range_m(double width_m, double largest_m, double nadir_m) {
  const double smallest = 3.0 * nadir_m;
  double best = smallest;
  int fewest = tracks_needed(width_m, smallest, nadir_m);
  const auto consider = [&](double range) {
    const int count = tracks_needed(width_m, range, nadir_m);
    if (count < fewest) {
      fewest = count;
      best = range;
    }
  };
  for (int i = 1; smallest + i <= largest_m + kTouching; ++i) consider(smallest + i);
  if (largest_m > smallest) consider(largest_m);
  return best;
}

TrackSpacingState start_spacing(const TrackSpacingOptions& options) {
  check(options);
  TrackSpacingState state;
  state.options = options;
  state.good_range_m = options.range_m;
  open_pair(state);
  return state;
}

double uncovered_m(const TrackSpacingState& state) {
  const double width = state.options.width_m;
  return std::max(0.0, width - state.covered.covered_m({0.0, width}));
}

std::optional<SurveyTrack> next_track(const TrackSpacingState& state) {
  if (const auto repair = repair_track(state)) return repair;
  if (state.edge_m > state.options.width_m - kTouching) return std::nullopt;
  const int number = static_cast<int>(state.sailed.size());
  const double across = state.in_pair == 0 ? first_of_pair_m(state)
                                           : state.sailed.back().across_m + partner_range_m(state) -
                                                 state.options.nadir_m;
  return SurveyTrack{number, across, number % 2 == 0};
}

TrackSpacingState observe(TrackSpacingState state, const SurveyTrack& track,
                          const DetectionCurve& curve) {
  return observe(std::move(state), track, SideCurves{curve, curve});
}

TrackSpacingState observe(TrackSpacingState state, const SurveyTrack& track,
                          const SideCurves& curves) {
  check_due(track, next_track(state));
  check(curves.port, fmt::format("track {}: P(y) curve (port)", track.number));
  check(curves.starboard, fmt::format("track {}: P(y) curve (starboard)", track.number));
  const bool repairs = repair_track(state).has_value();
  const auto stripe = repairs ? open_stripe(state) : std::nullopt;
  state.sailed.push_back(track);
  state.ranges_m.push_back(state.range_m);
  learn(state, track, curves);
  if (stripe) {
    close_repair(state, *stripe);
    return state;
  }
  if (++state.in_pair == (state.single ? 1 : 2)) close_pair(state);
  return state;
}

}  // namespace swathplan

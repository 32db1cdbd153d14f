#include "planners/adaptive/track_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "mesh/base/require.h"

namespace swathplan {
namespace {

constexpr double kTouching = 1e-6;  // widths that differ by a micrometre are the same

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

void learn(TrackSpacingState& state, const DetectionCurve& curve) {
  const TrackSpacingOptions& o = state.options;
  const auto good = admissible_range_m(curve, o.threshold);
  if (!o.adapt) return;
  // A tenth of a millimetre of rounding must not cost a metre of range.
  const double range = good ? std::floor(*good + 1e-4) : 0.0;
  state.range_too_short = range < 3.0 * o.nadir_m;
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

std::optional<SurveyTrack> next_track(const TrackSpacingState& state) {
  if (state.edge_m > state.options.width_m - kTouching) return std::nullopt;
  const int number = static_cast<int>(state.sailed.size());
  const double across = state.in_pair == 0 ? first_of_pair_m(state)
                                           : state.sailed.back().across_m + partner_range_m(state) -
                                                 state.options.nadir_m;
  return SurveyTrack{number, across, number % 2 == 0};
}

TrackSpacingState observe(TrackSpacingState state, const SurveyTrack& track,
                          const DetectionCurve& curve) {
  check_due(track, next_track(state));
  check(curve, fmt::format("track {}: P(y) curve", track.number));
  state.sailed.push_back(track);
  state.ranges_m.push_back(state.range_m);
  learn(state, curve);
  if (++state.in_pair == (state.single ? 1 : 2)) close_pair(state);
  return state;
}

}  // namespace swathplan

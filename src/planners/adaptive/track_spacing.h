#pragma once

#include <optional>
#include <vector>

#include "planners/adaptive/detection_curve.h"
#include "planners/adaptive/intervals.h"
#include "planners/adaptive/survey_track.h"

namespace swathplan {

struct TrackSpacingOptions {
  double width_m = 1212.0;  ///< of the area, across the tracks
  double length_m = 400.0;  ///< of a track
  double range_m = 145.0;   ///< r: largest range believed good before there is data
  double nadir_m = 40.0;    ///< r_n: half-width of the blind strip below the sonar, > 0
  double threshold = 0.05;  ///< smallest P(y) of good data, (0, 1)
  bool adapt = true;        ///< false: the control, which keeps `range_m` throughout
  /// An addition to the paper. A pair's second track is laid by what its first one saw. Where the
  /// plan has width to spare, pairs move towards the start edge, where the range is known least.
  /// Where data was worse than a pair was laid for, single tracks close the stripes that it left.
  bool careful = true;
  bool port_looks_back = true;  ///< on outbound tracks; matters where the sides differ
};
/// @throws UsageError if an option breaks its rule, among them range_m >= 3 nadir_m; names it.
void check(const TrackSpacingOptions& options);

/// Tracks that cover `width_m` with range r: pairs r - r_n apart cover 3 r - r_n; the last track
/// may be a single one, which has to cover no more than r - r_n.
[[nodiscard]] int tracks_needed(double width_m, double range_m, double nadir_m);
/// Polygon adaptation: of the ranges from 3 r_n to `largest` in steps of a metre (and `largest`
/// itself), the smallest one that needs the fewest tracks.
[[nodiscard]] double adapted_range_m(double width_m, double largest_m, double nadir_m);

/// The state of a survey; plain data. It begins as start_spacing(options).
struct TrackSpacingState {
  TrackSpacingOptions options;
  std::vector<SurveyTrack> sailed;
  std::vector<double> ranges_m;  ///< adapted range in force for each track sailed
  double good_range_m = 0.0;     ///< largest range now believed good
  double range_m = 0.0;          ///< adapted range of the pair that is being sailed
  double edge_m = 0.0;           ///< everything below it counts as covered
  double spare_m = 0.0;          ///< how far the pair was moved towards the start
  bool single = false;           ///< the pair is a single last track
  int in_pair = 0;               ///< tracks of the pair that are sailed
  /// True once data was good to less than 3 r_n, and ever after. Paired tracks cannot cover each
  /// other's nadir gaps then. The survey goes on at 3 r_n and leaves gaps.
  bool range_too_short = false;
  double port_m = 0.0,
         starboard_m = 0.0;  ///< up to where the last track's data was good; 0: nowhere
  IntervalSet covered;       ///< of the across axis, by each track's own good data
  int vain_repairs = 0;      ///< the last so many single tracks closed nothing
  double given_up_m = 0.0;   ///< stripes nearer to the start than this are not tried again
};
[[nodiscard]] TrackSpacingState start_spacing(const TrackSpacingOptions& options);

/// What one track lets the vehicle estimate, for each side.
struct SideCurves {
  DetectionCurve port, starboard;
};

/// Metres of the area's width that no track has covered with good data.
[[nodiscard]] double uncovered_m(const TrackSpacingState& state);

/// The next track; empty when the area is done. It may lie outside the area by up to r. Before a
/// new pair comes a single track for the first stripe of at least 5 m that the pairs left.
[[nodiscard]] std::optional<SurveyTrack> next_track(const TrackSpacingState& state);

/// The state after `track` was sailed and its curves estimated from its data. Pairs are planned
/// from the worse side; a dead side has a curve that stays below the threshold. The control only
/// checks that the curves are valid.
/// @throws InvalidInput if that track is not next_track(state), or a curve is not valid.
[[nodiscard]] TrackSpacingState observe(TrackSpacingState state, const SurveyTrack& track,
                                        const SideCurves& curves);
/// The same with one curve for both sides.
[[nodiscard]] TrackSpacingState observe(TrackSpacingState state, const SurveyTrack& track,
                                        const DetectionCurve& curve);

}  // namespace swathplan

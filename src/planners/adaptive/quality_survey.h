#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "planners/adaptive/survey_track.h"

namespace swathplan {

/// Which tracks may be chosen next. The rule looks at a track's probability of covering the first
/// swath that is still uncovered.
enum class GapConstraint {
  none,   ///< any probability; the track must have a benefit
  mild,   ///< above 0
  strong  ///< above 0.5
};
/// 'none', 'mild' or 'strong'; empty for anything else.
[[nodiscard]] std::optional<GapConstraint> gap_constraint(std::string_view name);
[[nodiscard]] std::string_view name(GapConstraint constraint);

struct QualitySurveyOptions {
  double width_m = 2000.0;    ///< of the area, across the tracks; a multiple of swath_m
  double length_m = 5000.0;   ///< of a track
  double swath_m = 10.0;      ///< width of the swaths that the area and the ranges are cut into
  double range_min_m = 40.0;  ///< nominal limits of the sonar; multiples of swath_m
  double range_max_m = 150.0;
  double quality = 2.0 / 3.0;  ///< peak correlation from which data is good, (0, 1)
  double cost_weight = 0.02;   ///< weight of the transit cost against swaths gained, >= 0
  double turn_width_m = 60.0;  ///< twice the turning radius: the spacing that costs nothing, > 0
  GapConstraint constraint = GapConstraint::strong;
  bool port_looks_back = true;  ///< on outbound tracks
};
/// @throws UsageError if an option breaks its rule; the message names it.
void check(const QualitySurveyOptions& options);
/// Number of ranges per side.
[[nodiscard]] int range_bins(const QualitySurveyOptions& options);

/// What a track observes: the peak correlation of successive pings, averaged over the track, for
/// each range bin from range_min_m outwards, in [-1, 1].
struct QualityObservation {
  std::vector<double> port, starboard;
};

/// The state of a survey; plain data. It begins as start_survey(options).
struct QualitySurveyState {
  QualitySurveyOptions options;
  std::vector<SurveyTrack> sailed;
  std::vector<char> covered;  ///< per swath: 1 once good data is there (the paper's first 'gamma')
  std::vector<int> good_port, good_starboard;  ///< per range bin: tracks that gave good data
  /// Tracks behind these counts. A bin's counts begin anew where the sonar has changed.
  std::vector<int> counted_port, counted_starboard;
  std::vector<SurveyTrack> vain;  ///< the last tracks, as far as they covered nothing new
};
[[nodiscard]] QualitySurveyState start_survey(const QualitySurveyOptions& options);

/// Expected success rate of a range bin: (good + 1) / (tracks + 2), the mean of the Beta posterior
/// with a flat prior. Two tracks in a row that cover nothing new show that the past says little
/// about today's sonar: the bins that failed on the second are then counted from this track on.
[[nodiscard]] double success_rate(const QualitySurveyState& state, bool port, int bin);
/// Transit cost of a track at `to` after one at `from`: (d / omega - 1)^2.
[[nodiscard]] double transit_cost(const QualitySurveyOptions& options, double from_m, double to_m);
/// Share of swaths covered, [0, 1].
[[nodiscard]] double covered_share(const QualitySurveyState& state);

/// Whether the survey ended because track after track covered nothing new: the sonar gives no good
/// data.
[[nodiscard]] bool nothing_gained(const QualitySurveyState& state);

/// The next track: the one with the highest utility, benefit - weight x cost, among those that the
/// constraint allows. Tracks lie on the grid of swath edges inside the area. Of equal tracks the
/// one nearest the start edge is taken. Where no track meets the constraint (before anything is
/// known, or after failures), those with the highest probability of covering the first uncovered
/// swath compete. After two tracks in a row that covered nothing new, the strong constraint holds.
/// Among such tracks no line is sailed more than twice in the same direction. Empty when all is
/// covered, when no track can cover more, or when nothing_gained().
[[nodiscard]] std::optional<SurveyTrack> next_track(const QualitySurveyState& state);

/// The state after `track` was sailed.
/// @throws InvalidInput if it is not next_track(state), or the observation has the wrong length, a
/// NaN or a correlation outside [-1, 1].
[[nodiscard]] QualitySurveyState observe(QualitySurveyState state, const SurveyTrack& track,
                                         const QualityObservation& observation);

}  // namespace swathplan

#pragma once

#include <vector>

#include "planners/adaptive/quality_survey.h"

namespace swathplan {

/// How the sonar really does, range bin by range bin: 1 where data is good.
struct TrueQuality {
  std::vector<char> port, starboard;
};
/// Good data from the nominal smallest range to `port_m` and `starboard_m`; 0: a dead side.
[[nodiscard]] TrueQuality true_quality(const QualitySurveyOptions& options, double port_m,
                                       double starboard_m);
/// What a track would then observe: correlation 1 where good, 0 elsewhere.
[[nodiscard]] QualityObservation observe_world(const TrueQuality& truth);

/// Sails the adaptive survey to its end.
[[nodiscard]] QualitySurveyState sail(const QualitySurveyOptions& options,
                                      const TrueQuality& truth);

/// Paired tracks for the nominal range: range_max - range_min apart within a pair, pairs
/// 3 range_max - range_min apart, as if all data were good; the last may be a single one.
/// Returned with what really was covered. Its tracks may lie outside the area.
[[nodiscard]] QualitySurveyState sail_preplanned(const QualitySurveyOptions& options,
                                                 const TrueQuality& truth);

/// Fewest tracks that cover everything when the truth is known: exact, by dynamic programming over
/// the first uncovered swath and what is covered beyond it. Tracks lie on the swath edges inside
/// the area, in order of the swath that they close. A track may run either way.
/// Empty if no set of tracks covers all.
[[nodiscard]] std::vector<SurveyTrack> fewest_tracks(const QualitySurveyOptions& options,
                                                     const TrueQuality& truth);

/// Metres of tracks and of the transits between them, from the first track's start to the last
/// one's end.
[[nodiscard]] double travel_m(const std::vector<SurveyTrack>& tracks, double length_m);

}  // namespace swathplan

#pragma once

#include <vector>

#include "planners/adaptive/quality_survey.h"

namespace swathplan {

/// The sonar's true performance per range bin: 1 where data is good.
struct TrueQuality {
  std::vector<char> port, starboard;
};
/// Good data from the nominal smallest range out to `port_m` and `starboard_m`; with 0 a side is
/// dead.
[[nodiscard]] TrueQuality true_quality(const QualitySurveyOptions& options, double port_m,
                                       double starboard_m);
/// What a track observes of such a sonar: correlation 1 where data is good, 0 elsewhere.
[[nodiscard]] QualityObservation observe_world(const TrueQuality& truth);

/// Sails the adaptive survey to its end.
[[nodiscard]] QualitySurveyState sail(const QualitySurveyOptions& options,
                                      const TrueQuality& truth);

/// Sails paired tracks that are planned for the nominal range, as if all data were good. The tracks
/// of a pair lie range_max - range_min apart, and pairs 3 range_max - range_min apart. The last
/// track may be a single one. Tracks may lie outside the area. Returns what was really covered.
[[nodiscard]] QualitySurveyState sail_preplanned(const QualitySurveyOptions& options,
                                                 const TrueQuality& truth);

/// Whether fewest_tracks() can be computed: twice the largest range lies within 64 swaths.
[[nodiscard]] bool optimum_known(const QualitySurveyOptions& options);

/// The fewest tracks that cover everything when the truth is known. Exact: dynamic programming over
/// the first uncovered swath and what is covered beyond it. Tracks lie on the swath edges inside
/// the area, in the order of the first swath that each covers. A track may run either way.
/// Empty if no set of tracks covers all. @throws UsageError where it is not optimum_known().
[[nodiscard]] std::vector<SurveyTrack> fewest_tracks(const QualitySurveyOptions& options,
                                                     const TrueQuality& truth);

/// Metres of tracks and of the transits between them, from the first track's start to the last
/// one's end.
[[nodiscard]] double travel_m(const std::vector<SurveyTrack>& tracks, double length_m);

}  // namespace swathplan

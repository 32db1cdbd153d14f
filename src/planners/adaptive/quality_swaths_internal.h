#pragma once

#include <cmath>
#include <vector>

#include "planners/adaptive/quality_survey.h"

namespace swathplan {

/// A number per range bin for each physical side.
struct SideRates {
  std::vector<double> port, starboard;
};

[[nodiscard]] inline int swath_count(const QualitySurveyOptions& o) {
  return static_cast<int>(std::lround(o.width_m / o.swath_m));
}

/// Index of the swath that a range bin of a track falls on; outside [0, count) beyond the area.
[[nodiscard]] inline int swath_at(const QualitySurveyOptions& o, double across_m, bool back,
                                  int bin) {
  const int track = static_cast<int>(std::lround(across_m / o.swath_m));
  const int first = static_cast<int>(std::lround(o.range_min_m / o.swath_m));
  return back ? track - first - bin - 1 : track + first + bin;
}

}  // namespace swathplan

#pragma once

#include <optional>

#include "mesh/plane/polygons.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// The long shores of an elongated water: of a channel the two between its ends, of a ring the
/// outer one and the inner one.
struct Banks {
  SurveyCurve one, other;
  std::vector<float>
      along;  ///< of each cell: 0 at one end of a channel, 1 at the other; empty: a ring
};

/// Empty where the largest water holds less than kMostOfArea of the area, or is not kElongated
/// times as long as it is wide on average. Ends are the two places with the longest way through
/// the water between them; banks stop kEndOfWidth widths short of that length, or run on as far as
/// they are straight, so that the end of a channel cut off square is none.
[[nodiscard]] std::optional<Banks> banks_of(const WaterRaster& raster, const Area& area);

inline constexpr double kMostOfArea = 0.9;
inline constexpr double kElongated = 4.0;
inline constexpr double kEndOfWidth = 1.0;

/// Where each cell lies between the banks; infinite outside.
struct BetweenBanks {
  std::vector<float> share;   ///< 0 at one bank, 1 at the other, measured in swaths
  std::vector<float> swaths;  ///< from bank to bank
  double mean_swaths = 0.0;   ///< over the area
};
[[nodiscard]] BetweenBanks between_banks(const WaterRaster& raster, const std::vector<float>& width,
                                         const Banks& banks);

/// A stretch of a channel, from `from` to `to` along it, and its number of lines.
struct ChannelSection {
  float from = 0.0F, to = 1.0F;
  int lines = 1;
  bool operator==(const ChannelSection&) const = default;
};
/// Few sections, each with about `density` lines a swath that lies across it.
[[nodiscard]] std::vector<ChannelSection> sections_of(const Banks& banks,
                                                      const BetweenBanks& between, double density);

/// In each section the level sets of the share at (k + 1/2)/lines: they run from end to end, closer
/// where the water is narrow. Where they would lie closer than kCrowded swaths, only the middle one
/// goes on. Sections of a ring hold all of it.
[[nodiscard]] std::vector<SurveyCurve> lines_between(const WaterRaster& raster, const Banks& banks,
                                                     const BetweenBanks& between,
                                                     const std::vector<ChannelSection>& sections,
                                                     int smooth_passes);
inline constexpr double kCrowded = 0.4;

}  // namespace swathplan

#pragma once

#include <optional>

#include "mesh/plane/polygons.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// The two long shores of an elongated water. A channel has one on either side, from end to end. A
/// ring has an outer and an inner one.
struct Banks {
  SurveyCurve one, other;
  std::vector<float>
      along;  ///< of each cell: 0 at one end of a channel, 1 at the other; empty: a ring
};

/// Finds the banks. Empty where the largest water holds less than kMostOfArea of the area, or is
/// not kElongated times as long as its mean width. The ends of a channel are the two places with
/// the longest way through the water between them. Banks stop kEndOfWidth widths short of the ends,
/// or run on as far as they are straight. So the square end of a channel does not become a bank.
[[nodiscard]] std::optional<Banks> banks_of(const WaterRaster& raster, const Area& area);

inline constexpr double kMostOfArea = 0.9;
inline constexpr double kElongated = 4.0;
inline constexpr double kEndOfWidth = 1.0;

/// Where each cell lies between the banks. Values are infinite outside the area.
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
/// Divides a channel into few sections. Each has about `density` lines for each swath that fits
/// across it.
[[nodiscard]] std::vector<ChannelSection> sections_of(const Banks& banks,
                                                      const BetweenBanks& between, double density);

/// Survey lines that run along the banks: in each section the level sets of the share at
/// (k + 1/2)/lines. They lie closer where the water is narrow. Where they would lie closer than
/// kCrowded swaths, only the middle one goes on. A section of a ring is the whole ring.
[[nodiscard]] std::vector<SurveyCurve> lines_between(const WaterRaster& raster, const Banks& banks,
                                                     const BetweenBanks& between,
                                                     const std::vector<ChannelSection>& sections,
                                                     int smooth_passes);
inline constexpr double kCrowded = 0.4;

}  // namespace swathplan

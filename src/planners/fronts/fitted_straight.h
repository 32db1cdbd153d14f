#pragma once

#include <optional>

#include "mesh/plane/area_query.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

struct StraightLinesOptions {
  Angle azimuth;             ///< of the lines, clockwise from north
  double percentile = 0.15;  ///< of the W along a line; the spacing follows it; [0, 1]
  int lines = 0;             ///< rows to lay; 0: as many as W asks for, rounded up
  double phase = 0.5;        ///< of the first row in its swath, (0, 1); 0.5: in the middle
  double inset_m = 0.05;     ///< lines stop this far before the area's outline
  /// The first and the last row lie this many swaths off the area's edges. The rows between them
  /// are spread evenly, counted in swaths. Empty: rows follow `phase`.
  std::optional<double> end_swaths = {};
  /// The same in shares of one row's part of the area, total / lines. 0.5 spreads rows evenly. With
  /// more, rows lie closer together: turns are short, and outer fans look outwards.
  std::optional<double> end_rows = {};
};

/// How many swaths lie across the area for straight lines of one direction.
struct RowWidths {
  double first_m = 0.0;        ///< across the lines, where the area begins
  double bin_m = 1.0;          ///< width of a bin across
  std::vector<double> swaths;  ///< integral of 1/W from first_m to the end of each bin

  [[nodiscard]] double total() const { return swaths.empty() ? 0.0 : swaths.back(); }
};

/// Takes the percentile of W along each bin and sums up the swaths across the area.
[[nodiscard]] RowWidths row_widths(const WaterRaster& raster, const std::vector<float>& width,
                                   Angle azimuth, double percentile);

/// Straight lines of one direction over the whole area, row by row. Row k of n lies where
/// (k + phase) / n of all swaths are behind it, so that rows lie closer over shoal ground. Rows are
/// cut to `lines_in` (where lines may run) and to the survey area. Pieces shorter than
/// kShortestPiece of the swath are left out.
[[nodiscard]] std::vector<SurveyCurve> fitted_straight_lines(const WaterRaster& raster,
                                                             const std::vector<float>& width,
                                                             const AreaQuery& survey_area,
                                                             const AreaQuery& lines_in,
                                                             const StraightLinesOptions& options);
inline constexpr double kShortestPiece = 0.15;

}  // namespace swathplan

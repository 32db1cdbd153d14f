#pragma once

#include <optional>

#include "mesh/plane/area_query.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

struct StraightLinesOptions {
  Angle azimuth;             ///< of the lines, clockwise from north
  double percentile = 0.15;  ///< of W along a line, that its spacing follows; [0, 1]
  int lines = 0;             ///< rows to lay; 0: as many as W asks for, rounded up
  double phase = 0.5;        ///< of the first row in its swath, (0, 1); 0.5: in the middle
  double inset_m = 0.05;     ///< lines stop this far before the area's outline
  /// The first and the last row lie so many swaths off the area's edges, those between them evenly
  /// in swaths; empty: by `phase`.
  std::optional<double> end_swaths = {};
  /// The same in shares of a row's part of the area, total / lines: 0.5 spreads rows evenly, more
  /// draws them together, so that turns are short and fans look outwards.
  std::optional<double> end_rows = {};
};

/// What straight lines of one direction would need.
struct RowWidths {
  double first_m = 0.0;        ///< across the lines, where the area begins
  double bin_m = 1.0;          ///< width of a bin across
  std::vector<double> swaths;  ///< integral of 1/W from first_m to the end of each bin

  [[nodiscard]] double total() const { return swaths.empty() ? 0.0 : swaths.back(); }
};

/// The percentile of W along each row across the area, as the running count of swaths.
[[nodiscard]] RowWidths row_widths(const WaterRaster& raster, const std::vector<float>& width,
                                   Angle azimuth, double percentile);

/// Straight lines of one direction over the whole area, row by row, with one count of swaths for
/// all of it: row k of n lies where (k + phase) / n of all swaths are behind it, so that rows stand
/// closer over shoal ground. Cut to `lines_in` (where lines may run) and to the survey area; pieces
/// shorter than kShortestPiece of the swath are left out.
[[nodiscard]] std::vector<SurveyCurve> fitted_straight_lines(const WaterRaster& raster,
                                                             const std::vector<float>& width,
                                                             const AreaQuery& survey_area,
                                                             const AreaQuery& lines_in,
                                                             const StraightLinesOptions& options);
inline constexpr double kShortestPiece = 0.15;

}  // namespace swathplan

#pragma once

#include <string>

#include "mesh/plane/area_query.h"
#include "planners/fronts/eikonal.h"
#include "planners/fronts/survey_curve.h"

namespace swathplan {

/// Where the front of field lines starts: a straight stretch of the area's outline.
struct FieldWall {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// The longest stretches of the outline that are straight to `tolerance_m`, longest first.
[[nodiscard]] std::vector<FieldWall> long_walls(const Area& area, double tolerance_m,
                                                std::size_t at_most);

struct FieldLinesOptions {
  double spacing = 1.0;        ///< swaths from line to line, > 0
  int smooth_passes = 60;      ///< of a binomial filter over points `step_m` apart
  double step_m = kCurveStep;  ///< > 0; a few times less than bends are wide
};

/// Survey lines along the level sets u = (k + 1/2) spacing, where |grad u| = 1/W and u = 0 on the
/// wall. Their spacing follows the depth. Their length is about the area's integral of 1/W, and no
/// plan without gaps is shorter (coarea formula). Lines are smoothed, then cut by `pieces_of`.
/// `tolerance_m`: the front starts from cells of the outline this near to the wall.
[[nodiscard]] std::vector<SurveyCurve> field_lines(const WaterRaster& raster,
                                                   const std::vector<float>& width,
                                                   const AreaQuery& lines_in, const FieldWall& wall,
                                                   double tolerance_m,
                                                   const FieldLinesOptions& options = {});

/// Cells of the area near a curve, from which a front advances to both of its sides.
[[nodiscard]] std::vector<FrontCell> front_along(const WaterRaster& raster,
                                                 const std::vector<float>& width,
                                                 const std::vector<SurveyCurve>& curves);

/// The level sets u = first + k spacing, k = 0, 1, ..., with points `step_m` apart. They are
/// smoothed by `smooth_passes` passes of a binomial filter, and not cut to any area.
[[nodiscard]] std::vector<SurveyCurve> front_lines(const WaterRaster& raster, const Front& front,
                                                   double first, double spacing, double step_m,
                                                   int smooth_passes);

/// The pieces of smooth curves inside `lines_in`. The pieces have kFieldParts times as many points.
/// Pieces shorter than kShortestField of their swath are left out.
[[nodiscard]] std::vector<SurveyCurve> pieces_of(const std::vector<SurveyCurve>& curves,
                                                 const WaterRaster& raster,
                                                 const std::vector<float>& width,
                                                 const AreaQuery& lines_in);

/// Integral of 1/W over the area: the least metres of line for gap-free coverage.
[[nodiscard]] double least_line_m(const WaterRaster& raster, const std::vector<float>& width);

/// With chords longer than this the course jumps in bends, and the outside of a bend is not
/// sounded.
inline constexpr double kFieldStep = 0.2;
// NOLINTNEXTLINE(bugprone-incorrect-roundings): lround is not constexpr
inline constexpr int kFieldParts = static_cast<int>(kCurveStep / kFieldStep + 0.5);
inline constexpr double kShortestField = 0.3;

}  // namespace swathplan

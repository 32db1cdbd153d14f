#pragma once

#include <map>
#include <memory>

#include "coverage/score.h"
#include "mesh/plane/area_query.h"
#include "planners/fronts/line_angles.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"
#include "planners/pareto.h"
#include "planners/rows/line_order.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// What of each swath is scored: what the options' margin leaves of it, or all.
enum class Swath { counted, whole };

/// What all candidates of one area share: rasters, queries and the simulator. `ground` and
/// `options` must outlive it.
class LineWorkshop {
 public:
  LineWorkshop(const PlanningGround& ground, const PlanOptions& options);

  [[nodiscard]] const PlanningGround& ground() const { return ground_; }
  [[nodiscard]] const PlanOptions& options() const { return options_; }
  [[nodiscard]] const WaterRaster& raster() const { return raster_; }
  [[nodiscard]] const AreaQuery& survey_area() const { return survey_area_; }
  /// Where lines may run: the water less kLineClearance.
  [[nodiscard]] const AreaQuery& lines_in() const { return lines_in_; }
  [[nodiscard]] const JoinCost& joins() const { return joins_; }
  /// W at a gap of `gap` scoring cells; kept.
  [[nodiscard]] const std::vector<float>& width(double gap);

  /// worth_per_ratio() for the area: by the least metres of line that leave no gap.
  [[nodiscard]] double price();

  /// Lines with their fans opened, ordered and joined.
  [[nodiscard]] BuiltRoute build(const std::vector<SurveyCurve>& lines,
                                 const std::vector<float>& width, const LineAnglesOptions& angles);
  /// Judges lines without steering a way between them: joins are estimated and sound nothing. A
  /// tenth of the work where the water is narrow.
  [[nodiscard]] Outcome estimate(const std::vector<SurveyCurve>& lines,
                                 const std::vector<float>& width, const LineAnglesOptions& angles,
                                 int coarse, std::string what);
  /// The route with its joins smoothed, if the options ask for it: candidates have arcs.
  [[nodiscard]] BuiltRoute finished(BuiltRoute built) const;
  /// Opened lines joined in the order given.
  [[nodiscard]] BuiltRoute join(const std::vector<std::vector<Waypoint>>& lines) const;

  /// Scores a route on the simulator. `coarse` > 1 makes cells, pings and beams that much coarser
  /// and the beams' footprints that much wider: about the same share of cells at that much less
  /// work, squared.
  [[nodiscard]] ScoredRoute score(const Route& route, int coarse = 1,
                                  Swath swath = Swath::counted) const;
  /// The share of cells that is covered, as the options count them, %.
  [[nodiscard]] double cover_pct(const Score& score) const;
  /// Whether cell i of a scored grid is.
  [[nodiscard]] bool covered(const CoverageGrid& grid, std::size_t i) const;
  [[nodiscard]] Outcome judge(const Route& route, int coarse, std::string what) const;

  static constexpr double kLineClearance = 0.05;

 private:
  /// Lines with their fans, in the order and sense that they are sailed in.
  [[nodiscard]] std::vector<std::vector<Waypoint>> sailed(const std::vector<SurveyCurve>& lines,
                                                          const std::vector<float>& width,
                                                          const LineAnglesOptions& angles) const;
  const PlanningGround& ground_;
  const PlanOptions& options_;
  PlanOptions with_arcs_;
  WaterRaster raster_;
  AreaQuery survey_area_, lines_in_;
  JoinCost joins_;
  std::map<double, std::vector<float>> widths_;
};

/// The ends of an opened line, for ordering.
[[nodiscard]] LineEnds ends_of(const std::vector<Waypoint>& line);
/// The same line sailed the other way: fans change sides and belong to the segment after them.
[[nodiscard]] std::vector<Waypoint> backwards(const std::vector<Waypoint>& line);

}  // namespace swathplan

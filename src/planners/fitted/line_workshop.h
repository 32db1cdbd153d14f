#pragma once

#include <map>
#include <memory>
#include <optional>

#include "coverage/score.h"
#include "mesh/plane/area_query.h"
#include "planners/fronts/line_angles.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"
#include "planners/pareto.h"
#include "planners/rows/line_order.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// The part of each swath that is scored: what the options' margin leaves of it, or all.
enum class Swath { counted, whole };

/// Builds and judges candidates for lines in one area. They share rasters, queries and the
/// simulator. `ground` and `options` must outlive it.
class LineWorkshop {
 public:
  /// `longest_cut`: as ConnectOptions has it, for the joins of lines; empty: its usual share.
  LineWorkshop(const Ground& ground, const PlanOptions& options,
               std::optional<double> longest_cut = {});

  [[nodiscard]] const Ground& ground() const { return ground_; }
  [[nodiscard]] const PlanOptions& options() const { return options_; }
  [[nodiscard]] const WaterRaster& raster() const { return raster_; }
  [[nodiscard]] const AreaQuery& survey_area() const { return survey_area_; }
  /// Where lines may run: the water less kLineClearance.
  [[nodiscard]] const AreaQuery& lines_in() const { return lines_in_; }
  [[nodiscard]] const JoinCost& joins() const { return joins_; }
  /// What joins the lines of all candidates.
  [[nodiscard]] const Connector& connector() const { return connector_; }
  /// W at a gap of `gap` scoring cells; where logged lines count, the swath with the largest area
  /// rate at that stretch (rate_width.h). It is computed once.
  [[nodiscard]] const std::vector<float>& width(double gap);

  /// Metres between pings over the water's mean depth.
  [[nodiscard]] double mean_ping_spacing_m() const;

  /// worth_per_ratio() for this area, from the least metres of line that leave no gap.
  [[nodiscard]] double price();

  /// Lines with their fans opened, ordered and joined.
  /// `edge_share`: as hold_fans takes it, where fans are held.
  [[nodiscard]] BuiltRoute build(const std::vector<SurveyCurve>& lines,
                                 const std::vector<float>& width, const LineAnglesOptions& angles,
                                 double edge_share = 1.0);
  /// Judges lines without steered joins: the metres of joins are estimated, and joins sound
  /// nothing. In narrow water this is a tenth of the work.
  [[nodiscard]] Outcome estimate(const std::vector<SurveyCurve>& lines,
                                 const std::vector<float>& width, const LineAnglesOptions& angles,
                                 int coarse, std::string what);
  /// The route with its joins smoothed, if the options ask for it. Candidates have plain arcs.
  [[nodiscard]] BuiltRoute with_smooth_joins(BuiltRoute built) const;
  /// Opened lines joined in the order given.
  [[nodiscard]] BuiltRoute join(const std::vector<std::vector<Waypoint>>& lines) const;

  /// Scores a route on the simulator. With `coarse` > 1 cells, pings and beams are coarser by that
  /// factor, and footprints wider. The share of covered cells is about the same, and the work is
  /// less by the square of the factor.
  [[nodiscard]] ScoredRoute score(const Route& route, int coarse = 1,
                                  Swath swath = Swath::counted) const;
  /// Scores a route on the true cells and hands out what its legs sound, as ScoreOptions has it.
  [[nodiscard]] ScoredRoute score(
      const Route& route,
      std::function<void(std::uint32_t, std::span<const std::uint32_t>)> logged_cells) const;
  /// The score of a route that is not sailed yet: the true cells, all empty.
  [[nodiscard]] ScoredRoute empty_score() const {
    return {{}, CoverageGrid(ground_.survey_area, options_.resolution_m, ground_.lattice)};
  }
  /// The share of cells that is covered, as the options count them, %.
  [[nodiscard]] double cover_pct(const ScoredRoute& scored) const;
  /// Whether cell i of a scored grid is covered, as the options count it.
  [[nodiscard]] bool covered(const CoverageGrid& grid, std::size_t i) const;
  [[nodiscard]] Outcome judge(const Route& route, int coarse, std::string what) const;
  /// The same of a route that is scored already.
  [[nodiscard]] Outcome judge(const ScoredRoute& scored, std::string what) const;

  /// Seconds of a join from one place and course to another, estimated: circles are sailed at the
  /// speed of turns, long straight ways at that of transits.
  [[nodiscard]] double join_seconds(const Vec2& a, const Vec2& course_a, const Vec2& b,
                                    const Vec2& course_b) const;

  static constexpr double kLineClearance = 0.05;

 private:
  /// Lines with their fans, in their order, each turned the way that it is sailed.
  [[nodiscard]] std::vector<std::vector<Waypoint>> sailed(const std::vector<SurveyCurve>& lines,
                                                          const std::vector<float>& width,
                                                          const LineAnglesOptions& angles,
                                                          double edge_share) const;
  /// Numbers the line from `number` on: a new number where a held fan or its speed changes. Returns
  /// the last one.
  [[nodiscard]] int numbered(std::vector<Waypoint>& line, int number) const;
  /// What joins cost: metres, and where logged lines count, seconds.
  [[nodiscard]] LineCost cost_of_joins() const;
  [[nodiscard]] ScoreOptions how_to_score(int coarse, Swath swath) const;
  [[nodiscard]] ScoredRoute score(const Route& route, int coarse, const ScoreOptions& how) const;
  const Ground& ground_;
  const PlanOptions& options_;
  PlanOptions with_arcs_;
  WaterRaster raster_;
  AreaQuery survey_area_, lines_in_;
  JoinCost joins_;
  Connector connector_;
  std::map<double, std::vector<float>> widths_;
};

/// The ends of an opened line, for ordering.
[[nodiscard]] LineEnds ends_of(const std::vector<Waypoint>& line);
/// The same line sailed the other way. Port and starboard fans change sides, and each fan stays on
/// its segment.
[[nodiscard]] std::vector<Waypoint> backwards(const std::vector<Waypoint>& line);

}  // namespace swathplan

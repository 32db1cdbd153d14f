#include "planners/fitted/line_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "mesh/base/error.h"
#include "planners/fitted/edge_following.h"
#include "planners/fronts/closing_passes.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/fronts/level_lines.h"
#include "planners/rows/line_order.h"
#include "planners/rows/survey_lines.h"
#include "planners/steering/water_path.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Shortest line, metres.
constexpr double kLeastLineM = 1.0;

/// Candidates run on so far beyond the area, as a share of W. Then ends that bring nothing are cut.
constexpr double kRunOn = 0.5;
/// Walls are straight to this share of the median W.
constexpr double kBankTolerance = 0.05;
constexpr std::size_t kBanks = 4;
constexpr double kFrontStepDeg = 15.0;
/// Isobaths that fronts start from: shares of the area that lie shoaler.
constexpr double kIsobaths[] = {0.02, 0.2, 0.5, 0.8};
/// A missed square metre costs about this many times as much as a swept one, since passes overlap.
constexpr double kMissedPrice = 1.5;
/// Number of the best fronts that are tried with each spacing.
constexpr std::size_t kBestFronts = 4;
constexpr double kSpacings[] = {1.0, 0.99, 0.98};
constexpr int kFieldSmoothing = 10;
constexpr double kHeadingStepDeg = 15.0;
constexpr std::size_t kBestHeadings = 3;
/// Percentile of the W along a row; the row's spacing follows it.
constexpr double kPercentiles[] = {0.0, 0.03, 0.1};
/// The largest number of rows tried is this many times the number that W asks for.
constexpr int kMostRows = 4;
constexpr double kEdgeMargins[] = {0.0, 0.03, 0.06, 0.1, 0.15, 0.2};
/// Number of the best candidates that are laid anew for the judge.
constexpr std::size_t kFinalists = 2;
/// The part of the share that may be missed which the search leaves free. The finer cells of the
/// judge may find more missed.
constexpr double kReserve = 0.1;

struct Source {
  std::string what;
  std::vector<SurveyCurve> curves;
};

/// How a set of lines is laid. It can be laid on cells of any size.
struct Recipe {
  std::string what;
  std::function<std::vector<SurveyCurve>(const SweptGround&)> lay;
  bool closed = false;  // passes close its gaps
};

struct Candidate {
  Recipe recipe;
  LinesFigures figures;
};

/// Tries candidates of all methods on one ground and keeps the shortest that miss little enough.
class LineDesigner {
 public:
  LineDesigner(const Ground& planning, const SweptGround& ground, const LineDesignOptions& options)
      : planning_(planning),
        ground_(ground),
        options_(options),
        lines_in_(planning.water),
        area_(planning.survey_area),
        allowed_((1.0 - kReserve) * options.most_missed) {}

  DesignedLines run(const SweptGround& judge) {
    const LineMethod m = options_.method;
    if (m == LineMethod::back_and_forth) back_and_forth();
    if (m == LineMethod::straight || m == LineMethod::automatic) straight();
    if (m == LineMethod::field || m == LineMethod::automatic) field();
    if (m == LineMethod::edge_following) edge_following();
    std::stable_sort(
        candidates_.begin(), candidates_.end(),
        [&](const Candidate& a, const Candidate& b) { return better(a.figures, b.figures); });
    DesignedLines best;
    options_.watch.phase("laying the best lines anew");
    for (std::size_t k = 0; k < std::min(kFinalists, candidates_.size()); ++k) {
      if (over() && !best.lines.empty()) break;
      DesignedLines laid = laid_out(candidates_[k].recipe, judge);
      if (best.lines.empty() || better(laid.figures, best.figures)) best = std::move(laid);
    }
    if (best.lines.empty()) {
      throw InvalidInput(
          "lines: no survey line fits into the water of the survey area; check <area> and <no go>");
    }
    best.ended_early = over();
    return best;
  }

 private:
  /// Whether the search is to end: with a candidate to keep.
  [[nodiscard]] bool over() const { return options_.watch.ended() && !candidates_.empty(); }

  /// Lays out the lines of a recipe. They are carried on, swept and cut back to what brings
  /// something; then their gaps are closed.
  [[nodiscard]] DesignedLines laid_out(const Recipe& recipe, const SweptGround& ground) const {
    std::vector<SurveyCurve> lines;
    for (const SurveyCurve& curve : recipe.lay(ground)) {
      for (const SurveyCurve& piece : cut_to(curve, lines_in_)) {
        lines.push_back(carried_on(piece, kRunOn, ground, lines_in_));
      }
    }
    DesignedLines result;
    result.what = recipe.what;
    result.lines = swept(lines, ground);
    trim_ends(result.lines, ground, 0.0);
    if (recipe.closed) {
      const std::size_t without = result.lines.size();
      add_closing_passes(result.lines, ground, lines_in_, allowed_);
      result.passes = result.lines.size() - without;
      trim_ends(result.lines, ground, 0.0);
      result.passes = std::min(result.passes, result.lines.size());
    }
    drop_short_pieces(result);
    result.figures = judge_lines(result.lines, ground);
    return result;
  }

  /// Drops the short pieces that islands and ragged edges leave of lines. They are not worth a
  /// turn.
  static void drop_short_pieces(DesignedLines& lines) {
    std::erase_if(lines.lines, [](const SweptLine& line) {
      double metres = 0.0;
      for (std::size_t i = 0; i + 1 < line.points.size() && metres < kLeastLineM; ++i) {
        metres += (line.points[i + 1] - line.points[i]).norm();
      }
      return metres < kLeastLineM;
    });
    lines.passes = std::min(lines.passes, lines.lines.size());
  }

  [[nodiscard]] bool enough(const LinesFigures& f) const { return f.missed <= allowed_; }
  [[nodiscard]] bool enough(const Recipe& r) const { return enough(laid_out(r, ground_).figures); }

  [[nodiscard]] bool better(const LinesFigures& a, const LinesFigures& b) const {
    if (enough(a) != enough(b)) return enough(a);
    return enough(a) ? a.length_m < b.length_m : a.missed < b.missed;
  }

  void offer(Recipe recipe) {
    DesignedLines d = laid_out(recipe, ground_);
    if (!d.lines.empty()) candidates_.push_back({std::move(recipe), d.figures});
    if (candidates_.empty()) return;
    const LinesFigures& best =
        std::min_element(candidates_.begin(), candidates_.end(), [&](const auto& a, const auto& b) {
          return better(a.figures, b.figures);
        })->figures;
    options_.watch.tried(
        candidates_.size(), 0,
        fmt::format("{:.0f} m, {:.3f} % missed", best.length_m, 100.0 * best.missed));
  }

  // Straight lines ------------------------------------------------------------------------------

  [[nodiscard]] double least_width() const {
    double least = 1e300;
    for (std::size_t i = 0; i < ground_.raster().size(); ++i) {
      if (ground_.raster().in_area(i)) {
        least = std::min(least, static_cast<double>(ground_.width()[i]));
      }
    }
    return least;
  }

  /// The fewest rows, from `fewest` on, that miss little enough; else `most`.
  template <class F>
  [[nodiscard]] int fewest_rows(int fewest, int most, const F& lines_of) const {
    int low = fewest;
    int high = fewest;
    for (int step = 1; high < most && !enough(lines_of(high)); step *= 2) {
      low = high + 1;
      high = std::min(most, high + step);
    }
    while (low < high) {
      const int middle = (low + high) / 2;
      if (enough(lines_of(middle))) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return high;
  }

  void back_and_forth() {
    const Angle azimuth =
        options_.heading.value_or(best_azimuth(planning_.survey_area, least_width()));
    const double across = width_across(azimuth);
    const auto even = [&](int rows) {
      return Recipe{fmt::format("{} even rows along {}", rows,
                                azimuth_text(azimuth.deg(), options_.grid_north.deg())),
                    [this, azimuth, spacing = across / rows](const SweptGround&) {
                      std::vector<SurveyCurve> curves;
                      for (const SurveyLine& line : parallel_lines(
                               planning_.survey_area,
                               {.azimuth = azimuth, .spacing_m = spacing, .inset_m = 0.0})) {
                        curves.push_back(straight_curve(line.from, line.to));
                      }
                      return curves;
                    }};
    };
    const int least = std::max(1, static_cast<int>(across / median_width()));
    const int most = std::max(least, static_cast<int>(std::ceil(2.0 * across / least_width())));
    const int rows = fewest_rows(least, most, even);
    offer(even(static_cast<int>(std::ceil(rows / (1.0 - options_.overlap) - 1e-9))));
  }

  [[nodiscard]] double width_across(Angle azimuth) const {
    const RowWidths rows = row_widths(ground_.raster(), ground_.width(), azimuth, 0.5);
    return rows.bin_m * static_cast<double>(rows.swaths.size());
  }

  [[nodiscard]] std::vector<Angle> best_headings() const {
    if (options_.heading) return {*options_.heading};
    std::vector<std::pair<double, double>> list;  // metres of line, degrees
    std::vector<double> degrees{best_azimuth(planning_.survey_area, least_width()).deg()};
    for (double deg = 0.0; deg < 180.0; deg += kHeadingStepDeg) {
      if (std::abs(deg - degrees[0]) > 1e-6) degrees.push_back(deg);
    }
    for (const double deg : degrees) {
      double metres = 0.0;
      for (const SurveyCurve& line : rows_of(Angle::degrees(deg), kPercentiles[1], 0, ground_)) {
        metres += length_m(line);
      }
      list.emplace_back(metres, deg);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Angle> best;
    for (std::size_t i = 0; i < std::min(kBestHeadings, list.size()); ++i) {
      best.push_back(Angle::degrees(list[i].second));
    }
    return best;
  }

  /// The swaths of the outermost rows end at the area's edges. Beyond them they would sweep nothing
  /// that counts.
  [[nodiscard]] std::vector<SurveyCurve> rows_of(Angle azimuth, double percentile, int rows,
                                                 const SweptGround& ground) const {
    return fitted_straight_lines(ground.raster(), ground.width(), area_, lines_in_,
                                 {.azimuth = azimuth,
                                  .percentile = percentile,
                                  .lines = rows,
                                  .inset_m = 0.0,
                                  .end_swaths = 0.5});
  }

  void straight() {
    for (const Angle azimuth : best_headings()) {
      for (const double percentile : kPercentiles) {
        if (over()) return;
        const double swaths =
            row_widths(ground_.raster(), ground_.width(), azimuth, percentile).total();
        // The outer halves of the first and the last row need no overlap.
        const int fewest =
            std::max(1, 1 + static_cast<int>(std::ceil((swaths - 1.0) / (1.0 - options_.overlap))));
        const auto spaced = [&](int rows) {
          return Recipe{fmt::format("{} rows along {}, spaced by the depth", rows,
                                    azimuth_text(azimuth.deg(), options_.grid_north.deg())),
                        [this, azimuth, percentile, rows](const SweptGround& ground) {
                          return rows_of(azimuth, percentile, rows, ground);
                        }};
        };
        offer(spaced(fewest_rows(fewest, kMostRows * fewest, spaced)));
      }
    }
  }

  // Curves --------------------------------------------------------------------------------------

  [[nodiscard]] double median_width() const {
    std::vector<float> widths;
    for (std::size_t i = 0; i < ground_.raster().size(); ++i) {
      if (ground_.raster().in_area(i)) widths.push_back(ground_.width()[i]);
    }
    if (widths.empty()) return 1.0;
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    return static_cast<double>(*middle);
  }

  [[nodiscard]] std::vector<FieldWall> walls() const {
    return long_walls(planning_.survey_area, kBankTolerance * median_width(), kBanks);
  }

  [[nodiscard]] std::vector<Source> fronts() const {
    std::vector<Source> list;
    for (const FieldWall& wall : walls()) {
      list.push_back({fmt::format("the wall from ({:.0f}, {:.0f}) to ({:.0f}, {:.0f})",
                                  wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y()),
                      {straight_curve(wall.from, wall.to)}});
    }
    const Box2 box = extent(planning_.survey_area);
    const Vec2 centre = 0.5 * (box.min + box.max);
    for (double deg = 0.0; deg < 180.0; deg += kFrontStepDeg) {
      const Angle a = Angle::degrees(deg);
      const Vec2 reach = box.size().norm() * Vec2(sin(a), cos(a));
      list.push_back({fmt::format("a line through the middle along {}",
                                  azimuth_text(deg, options_.grid_north.deg())),
                      {straight_curve(centre - reach, centre + reach)}});
    }
    add_isobaths(list);
    return list;
  }

  void add_isobaths(std::vector<Source>& list) const {
    const WaterRaster& raster = ground_.raster();
    std::vector<float> depths(raster.size(), std::numeric_limits<float>::infinity());
    std::vector<float> sorted;
    for (std::size_t i = 0; i < raster.size(); ++i) {
      if (!raster.in_area(i)) continue;
      depths[i] = static_cast<float>(raster.depth(i));
      sorted.push_back(depths[i]);
    }
    std::sort(sorted.begin(), sorted.end());
    if (sorted.empty() || !(sorted.front() < sorted.back())) return;
    for (const double share : kIsobaths) {
      const auto k = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
      const auto depth = static_cast<double>(sorted[k]);
      list.push_back(
          {fmt::format("the isobath of {:.0f} m", depth), level_lines(raster, depths, depth)});
    }
  }

  [[nodiscard]] Recipe along(const Source& source, double spacing, bool closed) const {
    const double s = spacing * (1.0 - options_.overlap);
    return {fmt::format("field lines from {}, {:.2f} swaths apart", source.what, s),
            [=, curves = source.curves](const SweptGround& ground) {
              const WaterRaster& raster = ground.raster();
              const Front front =
                  march(raster, ground.width(), front_along(raster, ground.width(), curves));
              return front_lines(raster, front, 0.5 * spacing, s, raster.cell_m(), kFieldSmoothing);
            },
            closed};
  }

  void field() {
    const std::vector<Source> sources = fronts();
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (over() || (options_.watch.ended() && !order.empty())) break;
      const LinesFigures f = laid_out(along(sources[i], 1.0, false), ground_).figures;
      if (f.lines > 0) order.emplace_back(f.ratio() + kMissedPrice * f.missed, i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < std::min(kBestFronts, order.size()); ++k) {
      for (const double spacing : kSpacings) {
        if (over()) return;
        offer(along(sources[order[k].second], spacing, true));
      }
    }
  }

  void edge_following() {
    const std::vector<FieldWall> all = walls();
    for (std::size_t w = 0; w < all.size(); ++w) {
      for (const double margin : kEdgeMargins) {
        if (over()) return;
        if (margin > 0.0 && margin <= options_.overlap) continue;
        const double kept = std::max(margin, options_.overlap);
        offer({fmt::format("edge to edge from wall {}, margin {:.0f} %", w + 1, 100.0 * kept),
               [this, wall = all[w], kept](const SweptGround& ground) {
                 return edge_following_lines(ground, lines_in_, wall,
                                             {.margin = kept,
                                              .step_m = ground.raster().cell_m(),
                                              .smooth_passes = kFieldSmoothing,
                                              .run_on = kRunOn});
               }});
      }
    }
  }

  const Ground& planning_;
  const SweptGround& ground_;
  const LineDesignOptions& options_;
  AreaQuery lines_in_, area_;
  double allowed_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void check(const LineDesignOptions& o) {
  if (!(o.overlap >= 0.0 && o.overlap <= 0.4)) {
    throw UsageError("overlap", fmt::format("{:g}", 100.0 * o.overlap),
                     "must lie in [0, 40] per cent");
  }
  if (!(o.most_missed > 0.0 && o.most_missed < 1.0)) {
    throw UsageError("missed", fmt::format("{:g}", 100.0 * o.most_missed),
                     "must be above 0 and under 100 per cent");
  }
}

DesignGround::DesignGround(const Ground& planning, Angle opening, double draft_m, double most_cells)
    : raster(planning, most_cells),
      width(opening_width(raster, opening, draft_m)),
      swaths(raster, width, draft_m) {}

DesignedLines design_lines(const Ground& planning, const DesignGround& search,
                           const DesignGround& judge, const LineDesignOptions& options) {
  check(options);
  return LineDesigner(planning, search.swaths, options).run(judge.swaths);
}

namespace {

/// Writes the route: line after line, and the way from each to the next.
class LineRoute {
 public:
  LineRoute(const Area& water, Angle opening, const Vehicle& vehicle)
      : ways_(water), opening_(opening), vehicle_(vehicle) {}

  void add(const std::vector<Vec2>& points) {
    if (!route_.waypoints.empty()) lead_to(points.front());
    Waypoint point;
    point.line = ++number_;
    point.fan = FanAngles{opening_ / 2.0, opening_ / 2.0};
    point.speed_mps = vehicle_.speed_mps;
    for (const Vec2& p : points) {
      point.position = p;
      route_.waypoints.push_back(point);
    }
    Waypoint& last = route_.waypoints.back();
    last.kind = LegKind::transit;
    last.log = false;
    last.line.reset();
    last.fan.reset();
    last.speed_mps = vehicle_.transit_speed_mps;
  }

  [[nodiscard]] Route finish() {
    if (!route_.waypoints.empty()) route_.waypoints.back().kind = LegKind::end;
    return std::move(route_);
  }

 private:
  /// Goes straight, or around land and no-go. Where no way leads there, the transit is infeasible.
  void lead_to(const Vec2& next) {
    const auto way = ways_.find(route_.waypoints.back().position, next);
    route_.waypoints.back().feasible = way.has_value();
    for (std::size_t i = 1; way && i + 1 < way->size(); ++i) {
      Waypoint corner = route_.waypoints.back();
      corner.position = (*way)[i];
      route_.waypoints.push_back(corner);
    }
  }

  WaterPath ways_;
  Angle opening_;
  const Vehicle& vehicle_;
  Route route_;
  int number_ = 0;
};

}  // namespace

Route route_of(const DesignedLines& designed, const Area& water, Angle opening,
               const Vehicle& vehicle) {
  std::vector<LineEnds> ends;
  for (const SweptLine& line : designed.lines) {
    const auto& p = line.points;
    ends.push_back({p.front(), p.back(), (p[1] - p[0]).normalized(),
                    (p[p.size() - 1] - p[p.size() - 2]).normalized()});
  }
  LineRoute route(water, opening, vehicle);
  for (const OrderedLine& next :
       line_order(ends, JoinCost(water, vehicle.turn_radius_m), std::nullopt)) {
    std::vector<Vec2> points = designed.lines[next.line].points;
    if (next.backwards) std::reverse(points.begin(), points.end());
    route.add(points);
  }
  return route.finish();
}

}  // namespace swathplan

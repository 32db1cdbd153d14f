#include "planners/fitted/fewest_hours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "mesh/base/error.h"
#include "planners/fitted/edge_following.h"
#include "planners/fitted/infill.h"
#include "planners/fitted/line_workshop.h"
#include "planners/fitted/pruning.h"
#include "planners/fronts/coverage_goal.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/fronts/headland.h"
#include "planners/fronts/rate_width.h"
#include "planners/rows/part_within.h"
#include "planners/rows/survey_lines.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// All candidates together may cost this many rays: some seconds of one core.
constexpr double kHoursRaysOfSearch = 1.5e8;
/// One candidate's judgement should not cost more than this many.
constexpr double kHoursRaysOfOne = 3e6;
constexpr int kHoursCoarsest = 6;
/// Where one exact score takes the better part of a minute, one plan alone is finished.
constexpr double kHoursRaysOfHuge = 4e8, kHoursRaysOfOneHuge = 1.5e7;
constexpr int kHoursCoarsestOfHuge = 12;
constexpr int kHoursFewest = 14, kHoursMost = 36;
constexpr std::size_t kHoursWalls = 3;
constexpr double kHoursDirectionStepDeg = 15.0;
constexpr std::size_t kHoursDirections = 4;
constexpr std::size_t kHoursFinalists = 4;
/// Where lines stop short of the goal, each point of coverage that is missing takes about this
/// share of the hours: passes over gaps are shorter than lines and have as many turns.
constexpr double kHoursOfPoint = 0.1;
/// Lines run on this share of their swath beyond the area, and are then cut back to where they
/// still cover some of it.
constexpr double kHoursRunOn = 0.6;
/// The ends of lines are worth sailing where a metre brings this share of the swath.
constexpr double kHoursTrimGain = 0.03;
/// Straight stretches of the outline count as walls to this share of the swath.
constexpr double kHoursWallTolerance = 0.1;
/// Points of lines lie this share of the swath apart, within limits: bends are drawn by them.
constexpr double kHoursStepOfSwath = 0.02;
constexpr double kHoursFinestStep = 0.2, kHoursCoarsestStep = 4.0;
/// Prices of infill: the share of the swath that a metre must bring. The highest price comes first.
constexpr double kHoursGains[] = {0.3, 0.13, 0.06, 0.03};
/// After so many ways without lines along the walls the others are left out, where the best of them
/// costs so much more than the best with such lines.
constexpr std::size_t kHoursTriedWithout = 2;
constexpr double kHoursHopeless = 1.15;
/// Finalists whose overlap is tuned to the goal, in so many steps, each followed by a score. Plans
/// within so many points of the goal are near enough.
constexpr int kHoursTunings = 2;
constexpr double kHoursNearGoal = 0.4;
/// Points of coverage that the whole swath as overlap would bring, where nothing else is known.
constexpr double kHoursPointsOfOverlap = 50.0;
constexpr double kHoursOverlapStep = 0.08, kHoursMostOverlap = 0.3;
/// A plan that covers so many points more than the goal keeps them: lines as far apart as the next
/// ones would be miss the goal.
constexpr double kHoursPrunedBeyond = 0.75;
/// Of the best finalists so many are pruned. Passes first cover so many points beyond the goal,
/// where a metre of them brings this share of the swath.
constexpr std::size_t kHoursExchanged = 2;
constexpr double kHoursBeyond[] = {0.5, 0.3};
constexpr double kHoursExchangeGain = 0.06;
/// What pieces of lines sound takes some tens of bytes a cell. Larger areas are not pruned.
constexpr double kHoursMostPrunedCells = 2e7;
/// Rounds of pruning, and points of coverage beyond the goal that it leaves: pings fall elsewhere
/// afterwards.
constexpr int kHoursPrunings = 2;
constexpr double kHoursReserve = 0.02;
/// Rounds of infill, each followed by a score.
constexpr int kHoursMostFillings = 6;
/// Plans that differ by less than this share are the same.
constexpr double kHoursSame = 5e-5;
constexpr int kHoursSmoothing = 60;
/// Field lines are smoothed over this many metres, and over no less than so many turn radii: where
/// two parts of a front meet at an angle, the boat could not follow the bend else.
constexpr double kHoursSmoothOverM = 10.0, kHoursSmoothOverRadii = 2.0;
constexpr double kHoursStepsOfRadius = 5.0;
/// Lines along walls are smoothed over so many turn radii. With the first one right angles bend by
/// about the radius, and the lines see the corners of shoal basins. In deep ones pings of so sharp
/// a bend lie far apart there.
constexpr double kHoursCorner = 0.7, kHoursWideCorner = 2.0;
/// Lines along walls lie so many swaths off, and if the foot of a wall is hard to see, so many.
constexpr double kHoursFromWall = 0.5, kHoursNearWall = 0.42;
/// Passes of the filter that smooth points `step` apart over `metres`: each widens a bell by half a
/// step squared.
int passes_over(double metres, double step) {
  return static_cast<int>(std::ceil(2.0 * (metres / step) * (metres / step)));
}
/// A detour that a join without a forward way asks for, turn radii.
constexpr double kHoursDetourRadii = 16.0 * std::numbers::pi;

/// Logged soundings of a cell are counted up to this (CoverageGrid).
constexpr double kMostCounted = 7.0;

/// Under this share of what the quickest plan takes, a limit holds no more than a part of a plan.
constexpr double kHoursOfPart = 0.7;

enum class Kind { rows, field, edges };

/// How a set of lines is laid.
struct Way {
  Kind kind = Kind::rows;
  double azimuth_deg = 0.0;  ///< of rows
  std::size_t wall = 0;      ///< of the others: the number among the longest walls of each water
  double overlap = 0.1, stretch = 1.0, percentile = 0.15;
  bool headland = false;         ///< lines along the walls first, the others in what they leave
  double corner = kHoursCorner;  ///< of lines along walls: smoothed over so many turn radii
  double from_wall = kHoursFromWall;  ///< of lines along walls, swaths
  double reach = 0.1;        ///< fans open past the boundary to the neighbour by this share of W
  double edge_share = 0.25;  ///< of the soundings wanted that a swath's edge has by itself
  bool operator==(const Way&) const = default;
};

/// What was changed of the lines that a way lays.
struct Counts {
  std::size_t passes = 0, dropped = 0, trimmed = 0;
};

struct Tried {
  Way way;
  BuiltRoute built;
  Outcome outcome;
  Counts counts = {};
};

double hours(const Outcome& outcome) { return outcome.duration_s / 3600.0; }

class HoursSearch {
 public:
  HoursSearch(const Ground& ground, const PlanOptions& options)
      : options_(options),
        shop_(ground, options),
        goal_(coverage_goal_pct(shop_.raster(), shop_.lines_in(), options)) {
    least_h_ = least_hours(shop_.raster(), options);
    walls_ = walls_without_room(ground.survey_area, AreaQuery(ground.water),
                                2.0 * options.vehicle.turn_radius_m, shop_.raster().cell_m());
    const std::vector<float>& width = this->width(1.0, 0.0);
    std::vector<float> some;
    std::copy_if(width.begin(), width.end(), std::back_inserter(some),
                 [](float w) { return w > 0.0F; });
    if (some.empty()) return;
    const auto low = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 10);
    std::nth_element(some.begin(), low, some.end());
    swath_m_ = static_cast<double>(*low);
  }

  Plan run() {
    if (!(swath_m_ > 0.0)) throw InvalidInput(kHoursNoLines);
    plan_the_budget();
    options_.watch.phase("searching");
    first_ways();
    if (pool_.empty()) throw InvalidInput(kHoursNoLines);
    calibrate();
    vary_the_best();
    finish_the_best();
    return picked();
  }

  std::vector<LaidLines> lines(std::size_t most) {
    if (!(swath_m_ > 0.0)) throw InvalidInput(kHoursNoLines);
    plan_the_budget();
    options_.watch.phase("searching");
    first_ways();
    if (pool_.empty()) throw InvalidInput(kHoursNoLines);
    vary_the_best();
    std::stable_sort(pool_.begin(), pool_.end(), [&](const Tried& a, const Tried& b) {
      return cost_h(a.outcome) < cost_h(b.outcome);
    });
    std::vector<LaidLines> result;
    for (Tried& tried : pool_) {
      if (result.size() == most) break;
      const bool known = std::any_of(result.begin(), result.end(), [&](const LaidLines& other) {
        return other.what == tried.outcome.what;
      });
      if (!known) result.push_back({std::move(tried.built), std::move(tried.outcome.what)});
    }
    return result;
  }

 private:
  static constexpr const char* kHoursNoLines =
      "no survey line fits into the water of the survey area; check <area>, <no go>, <least line> "
      "and the vehicle's draft and clearance";

  [[nodiscard]] const std::vector<float>& width(double stretch, double overlap) {
    auto [it, fresh] = widths_.try_emplace({stretch, overlap});
    if (fresh) it->second = rate_width_field(shop_.raster(), options_, stretch, overlap);
    return it->second;
  }

  void plan_the_budget() {
    const double path = least_line_m(shop_.raster(), width(1.0, 0.1)) * 1.2;
    rays_ = path / shop_.mean_ping_spacing_m() * options_.sonar.beams;
    while (coarse_ < kHoursCoarsest && rays_ / (coarse_ * coarse_) > kHoursRaysOfOne) ++coarse_;
    while (coarse_ < kHoursCoarsestOfHuge && rays_ / (coarse_ * coarse_) > kHoursRaysOfOneHuge) {
      ++coarse_;
    }
    const double each = rays_ / (coarse_ * coarse_);
    budget_ = std::clamp(static_cast<int>(kHoursRaysOfSearch / std::max(each, 1.0)), kHoursFewest,
                         kHoursMost);
  }

  // --- lines of a way

  /// The water that a way's lines are laid in, and the lines along the walls around it.
  struct Site {
    WaterRaster raster;
    std::vector<float> width;
    std::vector<SurveyCurve> headland;
  };

  [[nodiscard]] const Site& site(const Way& way) {
    const std::vector<float>& w = width(way.stretch, way.overlap);
    const auto [it, fresh] =
        sites_.try_emplace({way.stretch, way.overlap, way.headland, way.corner, way.from_wall},
                           Site{shop_.raster(), w, {}});
    Site& site = it->second;
    if (!fresh || !way.headland) return site;
    const double step = std::max(kCurveStep, options_.vehicle.turn_radius_m / kHoursStepsOfRadius);
    Headland headland = headland_along(
        walls_, shop_.raster(), w,
        {.from_wall = way.from_wall,
         .step_m = step,
         .smooth_passes = passes_over(way.corner * options_.vehicle.turn_radius_m, step)});
    site.raster = shop_.raster().only(headland.inner);
    for (std::size_t i = 0; i < w.size(); ++i) {
      if (headland.inner[i] == 0) site.width[i] = 0.0F;
    }
    site.headland = std::move(headland.lines);
    return site;
  }

  [[nodiscard]] std::vector<SurveyCurve> laid(const Way& way) {
    const Site& inner = site(way);
    const SweptGround ground(shop_.raster(), width(way.stretch, way.overlap),
                             options_.vehicle.draft_m);
    std::vector<SurveyCurve> curves;
    const bool any =
        std::any_of(inner.width.begin(), inner.width.end(), [](float w) { return w > 0.0F; });
    if (any && way.kind == Kind::rows) {
      curves =
          fitted_straight_lines(inner.raster, inner.width, shop_.survey_area(), shop_.lines_in(),
                                {.azimuth = Angle::degrees(way.azimuth_deg),
                                 .percentile = way.percentile,
                                 .inset_m = 0.0});
    } else if (any) {
      curves = from_walls(way, inner);
    }
    for (SurveyCurve& curve : curves) {
      curve = carried_on(std::move(curve), kHoursRunOn, ground, shop_.lines_in());
    }
    const std::size_t of_rows = curves.size();
    // Last, so that the ends of rows give way to them.
    for (const SurveyCurve& line : inner.headland) {
      for (SurveyCurve& piece : cut_to(line, shop_.lines_in())) curves.push_back(std::move(piece));
    }
    std::vector<SweptLine> lines = swept(curves, ground);
    trim_ends(lines, ground, kHoursTrimGain);
    const double step =
        std::clamp(kHoursStepOfSwath * swath_m_, kHoursFinestStep, kHoursCoarsestStep);
    std::vector<SurveyCurve> result;
    for (SweptLine& line : lines) {
      SurveyCurve curve{std::move(line.points)};
      if (length_m(curve) < options_.least_line_m || curve.points.size() < 2) continue;
      const bool row = way.kind == Kind::rows && result.size() < of_rows;
      if (!row) {
        const double apart = length_m(curve) / static_cast<double>(curve.points.size() - 1);
        curve = splined(curve, std::max(1, static_cast<int>(std::ceil(apart / step))));
      }
      for (SurveyCurve& piece : cut_to(resampled(curve, step), shop_.lines_in())) {
        if (piece.points.size() < 2 || length_m(piece) < options_.least_line_m) continue;
        result.push_back(std::move(piece));
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<SurveyCurve> from_walls(const Way& way, const Site& inner) {
    const SweptGround ground(inner.raster, inner.width, options_.vehicle.draft_m);
    const double tolerance = kHoursWallTolerance * swath_m_;
    std::vector<SurveyCurve> curves;
    for (const Polygon& water : shop_.ground().survey_area) {
      const auto walls = long_walls({water}, tolerance, kHoursWalls);
      if (walls.empty()) continue;
      FieldWall wall = walls[std::min(way.wall, walls.size() - 1)];
      if (way.headland) wall = moved_into(wall, inner);
      const auto lines = way.kind == Kind::field
                             ? field_lines(inner.raster, inner.width, shop_.lines_in(), wall,
                                           tolerance, field_smoothing())
                             : edge_following_lines(ground, shop_.lines_in(), wall,
                                                    {.margin = 0.0,
                                                     .step_m = std::max(kCurveStep, 0.1 * swath_m_),
                                                     .smooth_passes = kHoursSmoothing,
                                                     .least_m = options_.least_line_m});
      curves.insert(curves.end(), lines.begin(), lines.end());
    }
    return curves;
  }

  [[nodiscard]] FieldLinesOptions field_smoothing() const {
    const double over =
        std::max(kHoursSmoothOverM, kHoursSmoothOverRadii * options_.vehicle.turn_radius_m);
    const double step = std::max(kCurveStep, options_.vehicle.turn_radius_m / kHoursStepsOfRadius);
    return {.spacing = 1.0, .smooth_passes = passes_over(over, step), .step_m = step};
  }

  /// The wall at the inner edge of the headland along it.
  [[nodiscard]] static FieldWall moved_into(const FieldWall& wall, const Site& inner) {
    const Vec2 way = wall.to - wall.from;
    const Vec2 aside = Vec2(-way.y(), way.x()).normalized();
    const Vec2 middle = 0.5 * (wall.from + wall.to);
    for (double off = 0.0; off < way.norm(); off += inner.raster.cell_m()) {
      for (const double side : {1.0, -1.0}) {
        const auto cell = inner.raster.cell_at(middle + side * off * aside);
        if (cell && inner.width[*cell] > 0.0F) {
          return {wall.from + side * off * aside, wall.to + side * off * aside};
        }
      }
    }
    return wall;
  }

  [[nodiscard]] LineAnglesOptions angles(const Way& way) const {
    return {.overlap_m = 0.5 * options_.resolution_m,
            .overlap_share = way.reach / (1.0 - way.overlap),
            .widest_share = (0.6 + way.reach) / (1.0 - way.overlap),
            .by_distance = false};
  }

  [[nodiscard]] std::string described(const Way& way) const {
    std::string what;
    switch (way.kind) {
      case Kind::rows:
        what = fmt::format("straight lines at {} degrees", axis_degrees(way.azimuth_deg));
        break;
      case Kind::field:
        what = fmt::format("field lines from wall {}", way.wall + 1);
        break;
      case Kind::edges:
        what = fmt::format("edge-following lines from wall {}", way.wall + 1);
        break;
    }
    return fmt::format("{}{}, {:.0f} % overlap", what,
                       way.headland ? " within lines along the walls" : "", 100.0 * way.overlap);
  }

  [[nodiscard]] std::string described(const Tried& tried) const {
    const Counts& counts = tried.counts;
    std::string what = described(tried.way);
    if (counts.passes > 0) {
      what += ", " + counted(counts.passes, "infill pass", "infill passes");
    }
    if (counts.dropped > 0) what += fmt::format(", {} dropped", counts.dropped);
    if (counts.trimmed > 0) {
      what += ", " + counted(counts.trimmed, "end shortened", "ends shortened");
    }
    return what;
  }

  // --- search

  /// Hours, with what the missing coverage and the joins that cannot be steered will still cost.
  [[nodiscard]] double cost_h(const Outcome& o) const {
    const double missing = std::max(0.0, goal_ - o.cover_pct);
    return hours_to_pick_by(o.duration_s, o.cover_pct) + hours(o) * kHoursOfPoint * missing +
           detour_s() / 3600.0 * static_cast<double>(o.infeasible_legs);
  }
  [[nodiscard]] double detour_s() const {
    return kHoursDetourRadii * options_.vehicle.turn_radius_m / options_.vehicle.turn_speed_mps;
  }

  /// Whether the search is to end: with a candidate to keep.
  [[nodiscard]] bool over() const { return options_.watch.ended() && !pool_.empty(); }

  bool try_way(const Way& way) {
    if (over()) return false;
    if (std::find(known_.begin(), known_.end(), way) != known_.end()) return false;
    known_.push_back(way);
    const std::vector<SurveyCurve> curves = laid(way);
    if (curves.empty()) return false;
    Tried tried{
        way, shop_.build(curves, width(way.stretch, way.overlap), angles(way), way.edge_share), {}};
    if (tried.built.route.waypoints.size() < 2) return false;
    tried.outcome = shop_.judge(tried.built.route, coarse_, described(way));
    tried.outcome.cover_pct = std::clamp(tried.outcome.cover_pct + bias_, 0.0, 100.0);
    const bool better = pool_.empty() || cost_h(tried.outcome) < cost_h(pool_[best()].outcome);
    pool_.push_back(std::move(tried));
    options_.watch.tried(pool_.size(), static_cast<std::size_t>(budget_),
                         brief(pool_[best()].outcome));
    return better;
  }

  [[nodiscard]] std::size_t best() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < pool_.size(); ++i) {
      if (cost_h(pool_[i].outcome) < cost_h(pool_[best].outcome)) best = i;
    }
    return best;
  }

  [[nodiscard]] std::vector<double> directions() {
    if (options_.heading) return {options_.heading->deg()};
    struct Direction {
      double deg, metres;
    };
    std::vector<Direction> list;
    std::vector<double> azimuths{best_azimuth(shop_.ground().survey_area, swath_m_).deg()};
    for (double deg = 0.0; deg < 180.0; deg += kHoursDirectionStepDeg) azimuths.push_back(deg);
    for (const double deg : azimuths) {
      double metres = 0.0;
      for (const SurveyCurve& line :
           fitted_straight_lines(shop_.raster(), width(1.0, 0.1), shop_.survey_area(),
                                 shop_.lines_in(), {.azimuth = Angle::degrees(deg)})) {
        metres += length_m(line) + std::max(swath_m_, 3.0 * options_.vehicle.turn_radius_m);
      }
      list.push_back({deg, metres});
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const Direction& a, const Direction& b) { return a.metres < b.metres; });
    std::vector<double> result;
    for (std::size_t k = 0; k < std::min(kHoursDirections, list.size()); ++k) {
      result.push_back(list[k].deg);
    }
    return result;
  }

  /// Whether length or time is set far under what any plan takes: then a part of a plain plan is
  /// as good as that of the best.
  [[nodiscard]] bool holds_a_part_only() const {
    const PlanGoal& goal = options_.goal;
    if (!goal.length_m && !goal.time_s) return false;
    return std::none_of(pool_.begin(), pool_.end(), [&](const Tried& tried) {
      const Outcome& o = tried.outcome;
      return goal.length_m ? *goal.length_m > kHoursOfPart * o.length_m
                           : *goal.time_s > kHoursOfPart * o.duration_s;
    });
  }

  void first_ways() {
    if ((options_.goal.length_m || options_.goal.time_s) && options_.lines != LineSource::field) {
      for (const double deg : directions()) try_way({.kind = Kind::rows, .azimuth_deg = deg});
      if (!pool_.empty() && holds_a_part_only()) return;
    }
    for (const bool headland : {true, false}) {
      if (headland && walls_.empty()) continue;
      if (options_.lines != LineSource::field) {
        for (const double deg : directions()) {
          if (hopeless(headland)) return;
          try_way({.kind = Kind::rows, .azimuth_deg = deg, .headland = headland});
        }
      }
      if (options_.lines == LineSource::straight || options_.heading) continue;
      for (std::size_t wall = 0; wall < kHoursWalls; ++wall) {
        if (hopeless(headland)) return;
        try_way({.kind = Kind::field, .wall = wall, .headland = headland});
        if (!headland) try_way({.kind = Kind::edges, .wall = wall});
      }
    }
  }

  /// Whether lines without a headland were tried and came out far behind those with one.
  [[nodiscard]] bool hopeless(bool headland) const {
    if (headland || walls_.empty()) return false;
    double with = std::numeric_limits<double>::infinity();
    double without = with;
    std::size_t tried = 0;
    for (const Tried& t : pool_) {
      double& least = t.way.headland ? with : without;
      least = std::min(least, cost_h(t.outcome));
      tried += t.way.headland ? 0U : 1U;
    }
    return tried >= kHoursTriedWithout && without > kHoursHopeless * with;
  }

  /// Coarse cells cover a little more or less than the ones that count. What the best plan so far
  /// loses or gains by them, all others are taken to lose or gain.
  void calibrate() {
    if (coarse_ == 1 || over() || holds_a_part_only()) return;
    Tried tried = pool_[best()];
    const double coarse = tried.outcome.cover_pct;
    judge_in_full(tried);
    bias_ = tried.outcome.cover_pct - coarse;
    for (Tried& other : pool_) {
      other.outcome.cover_pct = std::clamp(other.outcome.cover_pct + bias_, 0.0, 100.0);
    }
  }

  void vary_the_best() {
    std::vector<Way> varied;
    if (holds_a_part_only()) return;
    while (static_cast<int>(known_.size()) < budget_ && !over()) {
      // The best that was not varied yet.
      std::optional<std::size_t> next;
      for (std::size_t i = 0; i < pool_.size(); ++i) {
        if (std::find(varied.begin(), varied.end(), pool_[i].way) != varied.end()) continue;
        if (!next || cost_h(pool_[i].outcome) < cost_h(pool_[*next].outcome)) next = i;
      }
      if (!next) return;
      const Way base = pool_[*next].way;
      varied.push_back(base);
      for (const Way& way : variations(base)) {
        if (static_cast<int>(known_.size()) >= budget_) return;
        if (try_way(way)) break;  // go on from there
      }
    }
  }

  [[nodiscard]] std::vector<Way> variations(const Way& base) {
    std::vector<Way> list;
    const auto vary = [&](auto member, auto value) {
      Way way = base;
      way.*member = value;
      list.push_back(way);
    };
    if (base.headland) {
      vary(&Way::from_wall, base.from_wall == kHoursFromWall ? kHoursNearWall : kHoursFromWall);
      vary(&Way::corner, base.corner == kHoursCorner ? kHoursWideCorner : kHoursCorner);
    }
    for (const double overlap : {0.03, 0.06, 0.14, 0.2, -0.04, -0.1}) vary(&Way::overlap, overlap);
    for (const double stretch : {1.15, 1.3, 0.9}) {
      // Where the fan's limit binds everywhere, the stretch changes nothing.
      if (width(stretch, base.overlap) != width(base.stretch, base.overlap)) {
        vary(&Way::stretch, stretch);
      }
    }
    for (const double reach : {0.1, 0.0, 0.2}) {
      if (reach != base.reach) vary(&Way::reach, reach);
    }
    if (base.kind == Kind::rows) {
      for (const double p : {0.05, 0.3, 0.5}) vary(&Way::percentile, p);
      if (!options_.heading) {
        vary(&Way::azimuth_deg, base.azimuth_deg + 5.0);
        vary(&Way::azimuth_deg, base.azimuth_deg - 5.0);
      }
    }
    return list;
  }

  // --- the best in full

  /// Returns what the route covers.
  CoverageGrid judge_in_full(Tried& tried) {
    ScoredRoute scored = shop_.score(tried.built.route);
    tried.outcome = shop_.judge(scored, tried.outcome.what);
    tried.outcome.hours_ratio = hours(tried.outcome) / std::max(least_h_, 1e-12);
    finished_.push_back(tried);
    options_.watch.tried(finished_.size(), 0, brief(tried.outcome));
    return std::move(scored.grid);
  }

  void finish_the_best() {
    std::vector<std::size_t> order(pool_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return cost_h(pool_[a].outcome) < cost_h(pool_[b].outcome);
    });
    const std::size_t finalists = rays_ > kHoursRaysOfHuge ? 1 : coarse_ >= 2 ? 2 : kHoursFinalists;
    options_.watch.phase("finishing the best");
    std::vector<Outcome> done;
    std::vector<Tried> filled;
    const std::size_t most = rays_ > kHoursRaysOfHuge || coarse_ >= 2 ? 1 : kHoursExchanged;
    for (const std::size_t i : order) {
      if (done.size() == finalists || (!done.empty() && options_.watch.ended())) break;
      // Variations that change nothing are the same plan again.
      const bool known = std::any_of(done.begin(), done.end(), [&](const Outcome& o) {
        return std::abs(o.duration_s - pool_[i].outcome.duration_s) < kHoursSame * o.duration_s &&
               std::abs(o.cover_pct - pool_[i].outcome.cover_pct) < 100.0 * kHoursSame;
      });
      if (known) continue;
      done.push_back(pool_[i].outcome);
      Tried tried = std::move(pool_[i]);
      CoverageGrid grid = judge_in_full(tried);
      std::optional<Route> part;
      if (!reaches(tried.outcome)) {
        part = part_within(tried.built.route, options_.goal, options_.least_line_m);
      }
      if (part) {
        tried.built = {std::move(*part), {}};
        tried.outcome.what += ", the part that the limit holds";
        judge_in_full(tried);
      } else {
        if (filled.size() < most && may_prune()) tune_overlap(tried, grid);
        filled.push_back(fill_in(tried, std::move(grid)));
      }
    }
    if (!may_prune()) return;
    std::erase_if(filled, [&](const Tried& tried) { return !reaches(tried.outcome); });
    std::stable_sort(filled.begin(), filled.end(), [&](const Tried& a, const Tried& b) {
      return cost_h(a.outcome) < cost_h(b.outcome);
    });
    for (std::size_t k = 0; k < std::min(most, filled.size()) && !options_.watch.ended(); ++k) {
      exchange(filled[k]);
    }
  }

  /// Lays the same lines with more or less overlap, until they cover about the goal: that is
  /// cheaper than passes over gaps, and coarse cells do not tell so exactly. `tried` and `grid`
  /// become those of the best.
  void tune_overlap(Tried& tried, CoverageGrid& grid) {
    double slope = kHoursPointsOfOverlap;
    Way way = tried.way;
    double cover = tried.outcome.cover_pct;
    const int most = rays_ > kHoursRaysOfHuge ? 1 : kHoursTunings;
    for (int k = 0; k < most && !options_.watch.ended(); ++k) {
      const double above = cover - goal_;
      if (std::abs(above) <= kHoursNearGoal || above > 100.0 * kHoursOverlapStep) return;
      const double step = std::clamp(-above / slope, -kHoursOverlapStep, kHoursOverlapStep);
      Way next = way;
      next.overlap = std::clamp(way.overlap + step, -kHoursMostOverlap, kHoursMostOverlap);
      if (next == way) return;
      const std::vector<SurveyCurve> curves = laid(next);
      if (curves.empty()) return;
      Tried now{
          next,
          shop_.build(curves, width(next.stretch, next.overlap), angles(next), next.edge_share),
          {}};
      if (now.built.route.waypoints.size() < 2) return;
      now.outcome.what = described(next);
      CoverageGrid seen = judge_in_full(now);
      slope = std::clamp((now.outcome.cover_pct - cover) / (next.overlap - way.overlap),
                         0.3 * kHoursPointsOfOverlap, 3.0 * kHoursPointsOfOverlap);
      way = next;
      cover = now.outcome.cover_pct;
      if (cost_h(now.outcome) < cost_h(tried.outcome)) {
        tried = std::move(now);
        grid = std::move(seen);
      }
    }
  }

  /// Plans are pruned that are judged by hits and by hours.
  [[nodiscard]] bool may_prune() const {
    const PlanGoal& goal = options_.goal;
    const double cells =
        area_m2(shop_.ground().survey_area) / (options_.resolution_m * options_.resolution_m);
    if (cells > kHoursMostPrunedCells || rays_ > kHoursRaysOfHuge) return false;
    return options_.criterion == nullptr && options_.cover == Cover::hit && !goal.length_m &&
           !goal.time_s && options_.run_in_m == 0.0 && options_.run_out_m == 0.0;
  }

  /// What pays most: passes over gaps until more than the goal is covered, then without what
  /// brings the least for its time. `tried` reaches the goal.
  void exchange(Tried tried) {
    std::optional<SoundedLines> seen = sounded(tried);
    // A plan that covers far more than the goal loses nothing but what costs no coverage.
    const double surplus = tried.outcome.cover_pct - goal_;
    const double floor =
        surplus > kHoursPrunedBeyond ? tried.outcome.cover_pct - 2.0 * kHoursReserve : goal_;
    for (const double beyond : kHoursBeyond) {
      if (!seen || options_.watch.ended()) return;
      const double before = cost_h(tried.outcome);
      Tried more = tried;
      const double missing = goal_ + beyond - more.outcome.cover_pct;
      if (missing > 0.0) {
        InfilledRoute filled =
            with_infill(more.built.route, seen->scored.grid, shop_,
                        {.least_gain = kHoursExchangeGain,
                         .enough_m2 = missing / 100.0 * area_m2(shop_.ground().survey_area),
                         .edge_share = more.way.edge_share});
        if (filled.passes > 0) {
          more.built = std::move(filled.built);
          more.counts.passes += filled.passes;
          std::optional<SoundedLines> with_passes = sounded(more);
          if (!with_passes) return;
          without_the_least(std::move(more), std::move(*with_passes), floor, tried, seen);
        }
      }
      // Also where no pass was worth it.
      if (cost_h(tried.outcome) >= before) {
        without_the_least(tried, SoundedLines(*seen), floor, tried, seen);
        return;
      }
    }
  }

  /// Judges the plan in full, piece by piece.
  [[nodiscard]] std::optional<SoundedLines> sounded(Tried& tried) {
    SoundedLines seen = sounded_stretches(tried.built.route, shop_);
    if (seen.lines.empty()) return std::nullopt;
    tried.outcome = shop_.judge(seen.scored, described(tried));
    tried.outcome.hours_ratio = hours(tried.outcome) / std::max(least_h_, 1e-12);
    // Pieces of a line are legs of that score.
    const auto& w = tried.built.route.waypoints;
    const std::vector<Leg> all = legs(tried.built.route);
    tried.outcome.infeasible_legs = static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const Leg& leg) { return !w[leg.first].feasible; }));
    return seen;
  }

  /// Prunes `from`, which `seen` was counted of, down to `floor` per cent. What is better goes into
  /// `best`, with what was counted of it.
  void without_the_least(Tried from, SoundedLines seen, double floor, Tried& best,
                         std::optional<SoundedLines>& seen_of_best) {
    double reserve = kHoursReserve;
    for (int k = 0; k < kHoursPrunings && !options_.watch.ended(); ++k) {
      PrunedRoute less = pruned(seen, shop_,
                                {.goal_pct = std::min(floor + reserve, from.outcome.cover_pct),
                                 .seconds_of_point = kHoursOfPointBeyond * from.outcome.duration_s,
                                 .detour_s = detour_s()});
      if (less.dropped + less.trimmed == 0) return;
      Tried now = from;
      now.built = std::move(less.built);
      now.counts.dropped += less.dropped;
      now.counts.trimmed += less.trimmed;
      std::optional<SoundedLines> again = sounded(now);
      if (!again) return;
      const double short_of = floor - now.outcome.cover_pct;
      if (short_of > 0.0) {
        // Turns took more of the lines than was counted.
        reserve += kHoursReserve + short_of;
        continue;
      }
      if (cost_h(now.outcome) >= cost_h(from.outcome)) return;
      from = std::move(now);
      seen = std::move(*again);
      if (cost_h(from.outcome) < cost_h(best.outcome)) {
        best = from;
        seen_of_best = seen;
        finished_.push_back(best);
        options_.watch.tried(finished_.size(), 0, brief(best.outcome));
      }
    }
  }

  /// Returns the last of the filled plans.
  Tried fill_in(const Tried& base, CoverageGrid grid) {
    Tried now = base;
    std::size_t price = 0;
    const int most = rays_ > kHoursRaysOfHuge ? 2 : kHoursMostFillings;
    const double area = area_m2(shop_.ground().survey_area);
    for (int round = 0; round < most && price < std::size(kHoursGains);) {
      const double missing = goal_ - now.outcome.cover_pct;
      if (missing <= 0.0 || options_.watch.ended()) break;
      InfilledRoute filled = with_infill(now.built.route, grid, shop_,
                                         {.least_gain = kHoursGains[price],
                                          .enough_m2 = missing / 100.0 * area,
                                          .edge_share = base.way.edge_share});
      if (!filled.enough) ++price;
      if (filled.passes == 0) continue;
      ++round;
      now.counts.passes += filled.passes;
      now.built = std::move(filled.built);
      now.outcome.what = described(now);
      grid = judge_in_full(now);
    }
    return now;
  }

  // --- the pick

  [[nodiscard]] bool reaches(const Outcome& o) const {
    const PlanGoal& goal = options_.goal;
    if (goal.length_m) return o.length_m <= *goal.length_m;
    if (goal.time_s) return o.duration_s <= *goal.time_s;
    return o.cover_pct >= goal_;
  }

  [[nodiscard]] Pick pick_of(const std::vector<Outcome>& list) const {
    const PlanGoal& goal = options_.goal;
    const bool most_cover = goal.length_m || goal.time_s;
    const auto less = [&](const Outcome& a, const Outcome& b) {
      if (reaches(a) != reaches(b)) return reaches(a);
      if (most_cover && reaches(a)) return a.cover_pct > b.cover_pct;
      if (!reaches(a)) return a.cover_pct > b.cover_pct;
      return cost_h(a) < cost_h(b);
    };
    const auto best = std::min_element(list.begin(), list.end(), less);
    const auto index = static_cast<std::size_t>(best - list.begin());
    if (most_cover) {
      const std::string limit = goal.length_m ? fmt::format("{:g} m of path", *goal.length_m)
                                              : fmt::format("{:.4g} h", *goal.time_s / 3600.0);
      return {index, reaches(*best)
                         ? fmt::format("the most coverage within {}", limit)
                         : fmt::format("no plan that was tried stays within {}: this one takes the "
                                       "least for its coverage",
                                       limit)};
    }
    if (reaches(*best)) {
      return {index,
              fmt::format("the fewest hours whose logged lines cover at least {:.4g} % of the "
                          "cells; a point more counts {:g} % of the hours",
                          goal_, 100.0 * kHoursOfPointBeyond)};
    }
    return {index, fmt::format("no plan that was tried reaches {:.4g} %: this one has the most "
                               "coverage",
                               goal_)};
  }

  Plan picked() {
    // What no other beats in hours and coverage, the quickest first.
    std::stable_sort(finished_.begin(), finished_.end(), [&](const Tried& a, const Tried& b) {
      return cost_of_steering(a.outcome) < cost_of_steering(b.outcome);
    });
    std::vector<Tried> front;
    for (Tried& tried : finished_) {
      const bool beaten = std::any_of(front.begin(), front.end(), [&](const Tried& other) {
        return other.outcome.cover_pct >= tried.outcome.cover_pct;
      });
      if (!beaten) front.push_back(std::move(tried));
    }
    Plan plan;
    for (const Tried& tried : front) plan.choices.push_back(tried.outcome);
    const Pick pick = pick_of(plan.choices);
    plan.chosen = pick.index;
    plan.chosen_why = pick.why;
    BuiltRoute built = shop_.with_smooth_joins(std::move(front[pick.index].built));
    plan.route = std::move(built.route);
    plan.notes = std::move(built.notes);
    plan.notes.push_back(fmt::format("of {}, {} was picked: {}",
                                     counted(plan.choices.size(), "choice"),
                                     plan.choices[pick.index].what, pick.why));
    if (options_.watch.ended()) plan.notes.push_back(ended_early_note(pool_.size(), "plan"));
    return plan;
  }
  [[nodiscard]] double cost_of_steering(const Outcome& o) const {
    Outcome covered = o;
    covered.cover_pct = 100.0;
    return cost_h(covered);
  }

  const PlanOptions& options_;
  LineWorkshop shop_;
  double goal_;           ///< per cent of the cells
  double least_h_ = 0.0;  ///< hours that no plan can go under
  double swath_m_ = 0.0;  ///< a narrow swath of the area
  double rays_ = 0.0;     ///< of one plan, about
  double bias_ = 0.0;     ///< points of coverage, from coarse cells to those that count
  int coarse_ = 1, budget_ = kHoursFewest;
  std::map<std::pair<double, double>, std::vector<float>> widths_;
  std::map<std::tuple<double, double, bool, double, double>, Site> sites_;
  std::vector<SurveyCurve> walls_;  ///< of the area, with no room to turn beyond
  std::vector<Way> known_;
  std::vector<Tried> pool_, finished_;
};

}  // namespace

Plan plan_fewest_hours(const Ground& ground, const PlanOptions& options) {
  check(options);
  if (options.soundings > kMostCounted) {
    throw UsageError("soundings", fmt::format("{:g}", options.soundings),
                     fmt::format("must be at most {:g} where lines are laid for the fewest hours: "
                                 "more logged soundings of a cell are not told apart",
                                 kMostCounted));
  }
  return HoursSearch(ground, options).run();
}

std::vector<LaidLines> lines_for_fewest_hours(const Ground& ground, const PlanOptions& options,
                                              std::size_t most) {
  check(options);
  return HoursSearch(ground, options).lines(most);
}

}  // namespace swathplan

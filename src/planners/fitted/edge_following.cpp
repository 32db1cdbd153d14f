#include "planners/fitted/edge_following.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/base/error.h"
#include "planners/fitted/line_workshop.h"
#include "planners/fronts/level_lines.h"

namespace swathplan {
namespace {

/// A line lies so many swaths ahead of the edge. Where no line fits, this distance is halved, up to
/// kHalvings times: strips narrower than half a swath are left then.
constexpr int kHalvings = 3;
/// A line must sweep at least this share of W in new square metres per metre.
constexpr double kLeastGain = 0.05;
/// The loop surely ends: no area takes more rounds than this.
constexpr int kMostRounds = 5000;

class EdgeFollower {
 public:
  EdgeFollower(const SweptGround& ground, const AreaQuery& lines_in,
               const EdgeFollowingOptions& options)
      : ground_(ground), lines_in_(lines_in), options_(options), open_(ground.width()) {}

  std::vector<SurveyCurve> run(const FieldWall& wall) {
    add_front({straight_curve(wall.from, wall.to)});
    double ahead = 0.5;
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<SurveyCurve> laid = lay(ahead);
      if (laid.empty() && !halved(ahead)) break;
      if (laid.empty()) continue;
      lines_.insert(lines_.end(), laid.begin(), laid.end());
      ahead = 0.5 - options_.margin;
    }
    return std::move(lines_);
  }

 private:
  static bool halved(double& ahead) {
    ahead *= 0.5;
    return ahead > 0.5 * std::pow(0.5, kHalvings) * 0.5;
  }

  /// The lines `ahead` swaths before the edge that sweep enough.
  std::vector<SurveyCurve> lay(double ahead) {
    const WaterRaster& raster = ground_.raster();
    const Front front = march(raster, open_, front_, ahead + kBeyond);
    std::vector<SurveyCurve> laid;
    std::vector<SurveyCurve> edges;
    for (const SurveyCurve& chain : level_lines(raster, front.u, ahead)) {
      const SurveyCurve smooth =
          smoothed(resampled(chain, options_.step_m), options_.smooth_passes);
      for (SurveyCurve& piece : cut_to(run_on(smooth), lines_in_)) {
        if (piece.points.size() < 3 || length_m(piece) < options_.least_m) continue;
        std::vector<SweptLine> one{swept(piece, ground_)};
        if (one[0].steps() == 0 || !worth_it(one[0])) continue;
        take(one[0], edges);
        laid.push_back(std::move(piece));
      }
    }
    add_front(edges);
    return laid;
  }

  [[nodiscard]] SurveyCurve run_on(const SurveyCurve& curve) const {
    return carried_on(curve, options_.run_on, ground_, lines_in_);
  }

  [[nodiscard]] bool worth_it(const SweptLine& line) const {
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t cell : line.cells) {
      if (open_[cell] > 0.0F) fresh.push_back(cell);
    }
    std::sort(fresh.begin(), fresh.end());
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    const double cell = ground_.raster().cell_m();
    const double w = ground_.width_m(line.points[line.points.size() / 2]);
    return static_cast<double>(fresh.size()) * cell * cell >
           kLeastGain * w * length_m(SurveyCurve{line.points});
  }

  /// Marks what the line sweeps. Its outline is added to `edges`.
  void take(const SweptLine& line, std::vector<SurveyCurve>& edges) {
    for (const std::uint32_t cell : line.cells) open_[cell] = 0.0F;
    edges.push_back({line.port});
    edges.push_back({line.starboard});
    edges.push_back(straight_curve(line.port.front(), line.starboard.front()));
    edges.push_back(straight_curve(line.port.back(), line.starboard.back()));
  }

  void add_front(const std::vector<SurveyCurve>& edges) {
    for (const FrontCell& cell : front_along(ground_.raster(), open_, edges)) {
      front_.push_back(cell);
    }
    std::erase_if(front_, [&](const FrontCell& f) { return !(open_[f.cell] > 0.0F); });
  }

  static constexpr double kBeyond = 0.1;  // the level needs cells on its far side
  const SweptGround& ground_;
  const AreaQuery& lines_in_;
  EdgeFollowingOptions options_;
  std::vector<float> open_;  // W where nothing is swept yet, else 0
  std::vector<FrontCell> front_;
  std::vector<SurveyCurve> lines_;
};

constexpr std::size_t kWalls = 3;
constexpr double kGap = 1.2;
constexpr LineAnglesOptions kAngles{.overlap_m = 0.5, .widest_share = 1.0, .by_distance = false};
/// Walls are straight to this share of a lane: quays have steps and bollards.
constexpr double kWallTolerance = 0.1;

}  // namespace

std::vector<SurveyCurve> edge_following_lines(const SweptGround& ground, const AreaQuery& lines_in,
                                              const FieldWall& wall,
                                              const EdgeFollowingOptions& options) {
  return EdgeFollower(ground, lines_in, options).run(wall);
}

namespace {

std::vector<SurveyCurve> pieces_from(const FieldWall& wall, const SweptGround& swaths,
                                     const LineWorkshop& shop) {
  std::vector<SurveyCurve> lines;
  const PlanOptions& how = shop.options();
  for (const SurveyCurve& line :
       edge_following_lines(swaths, shop.lines_in(), wall,
                            {.margin = how.lines_margin, .least_m = how.least_line_m})) {
    for (SurveyCurve& piece : cut_to(splined(line, kFieldParts), shop.lines_in())) {
      if (piece.points.size() < 3 || length_m(piece) < how.least_line_m) continue;
      lines.push_back(std::move(piece));
    }
  }
  return lines;
}

/// The lines of one of the separate waters. They start from the wall with the best score, or,
/// without a scene, from the first one. `ended` tells whether walls were left out, since the watch
/// ended the search.
std::vector<SurveyCurve> lines_of_water(const Polygon& water, const SweptGround& swaths,
                                        const std::vector<float>& width, LineWorkshop& shop,
                                        bool& ended) {
  const double tolerance = kWallTolerance * lane_m(shop.options());
  std::vector<SurveyCurve> best;
  double best_worth = 0.0;
  const Watch& watch = shop.options().watch;
  std::size_t tried = 0;
  for (const FieldWall& wall : long_walls({water}, tolerance, kWalls)) {
    if (watch.ended() && !best.empty()) {
      ended = true;
      break;
    }
    std::vector<SurveyCurve> lines = pieces_from(wall, swaths, shop);
    if (lines.empty()) continue;
    if (shop.ground().scene == nullptr) return lines;
    constexpr int kCoarse = 2;
    const Outcome outcome = shop.estimate(lines, width, kAngles, kCoarse, {});
    if (best.empty() || worth(outcome) > best_worth) {
      best = std::move(lines);
      best_worth = worth(outcome);
    }
    watch.tried(++tried, kWalls, fmt::format("{:.1f} %", outcome.cover_pct));
  }
  return best;
}

}  // namespace

Plan plan_edge_following(const Ground& ground, const PlanOptions& options) {
  check(options);
  LineWorkshop shop(ground, options);
  const std::vector<float>& width = shop.width(kGap);
  const SweptGround swaths(shop.raster(), width, options.vehicle.draft_m);
  std::vector<SurveyCurve> lines;
  Plan plan;
  bool ended = false;
  std::size_t number = 0;
  for (const Polygon& water : ground.survey_area) {
    options.watch.phase(
        ground.survey_area.size() == 1
            ? "trying walls"
            : fmt::format("trying walls of water {} of {}", ++number, ground.survey_area.size()));
    const auto here = lines_of_water(water, swaths, width, shop, ended);
    lines.insert(lines.end(), here.begin(), here.end());
    if (here.empty()) {
      const Vec2 at = ground.seafloor->frame.to_file(inner_point({water}));
      plan.notes.push_back(
          fmt::format("no line fits into the water of {:.0f} m2 about ({:.1f}, {:.1f})",
                      area_m2({water}), at.x(), at.y()));
    }
  }
  if (lines.empty()) {
    throw InvalidInput(
        "edge-following: no survey line fits into the water of the survey area; check <area>, "
        "<no go> and the vehicle's draft and clearance");
  }
  options.watch.phase("joining lines");
  BuiltRoute built = shop.with_smooth_joins(shop.build(lines, width, kAngles));
  plan.route = std::move(built.route);
  plan.notes.insert(plan.notes.end(), built.notes.begin(), built.notes.end());
  if (ended) {
    plan.notes.emplace_back("search ended early: not every wall was tried as the first line's");
  }
  return plan;
}

}  // namespace swathplan

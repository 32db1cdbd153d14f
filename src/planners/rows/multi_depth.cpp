#include "planners/rows/multi_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "planners/line_spacing.h"
#include "planners/rows/back_and_forth.h"
#include "planners/rows/row_order.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Notes say of this many regions how far apart their lines lie.
constexpr std::size_t kRegionsSaid = 4;

/// A region with its lines.
struct RegionLines {
  BlockLines laid;
  std::vector<SurveyLine> lines;
};

double nearest_end(const std::vector<SurveyLine>& lines, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const SurveyLine& line : lines) {
    best = std::min({best, (line.from - p).norm(), (line.to - p).norm()});
  }
  return best;
}

using OrderLines = std::function<std::vector<SurveyLine>(const std::vector<SurveyLine>&,
                                                         const std::optional<Vec2>& at)>;

/// The route through all regions. The nearest region is always the next. Lines of a region keep
/// their order.
BuiltRoute region_by_region(const std::vector<RegionLines>& regions, const Ground& ground,
                            const PlanOptions& options, const Connector& connector,
                            const OrderLines& order) {
  RouteBuilder builder(ground, options, connector);
  std::vector<char> done(regions.size(), 0);
  std::optional<Vec2> at = options.start;
  int number = 1;
  for (std::size_t round = 0; round < regions.size(); ++round) {
    std::size_t pick = regions.size();
    for (std::size_t r = 0; r < regions.size(); ++r) {
      if (done[r] != 0) continue;
      if (pick == regions.size() ||
          (at && nearest_end(regions[r].lines, *at) < nearest_end(regions[pick].lines, *at))) {
        pick = r;
      }
    }
    done[pick] = 1;
    if (regions[pick].lines.empty()) continue;
    for (const SurveyLine& line : order(regions[pick].lines, at)) {
      auto points = line_waypoints(line, number++, regions[pick].laid.fan, options);
      for (Waypoint& point : points) point.region = static_cast<int>(pick);
      builder.add_line(points);
    }
    at = builder.at();
  }
  return builder.built();
}

BlockLines laid_over(const DepthRegion& region, const Area& outline, const Ground& ground,
                     const PlanOptions& options) {
  if (options.rows.swath_by == SwathBy::fan) {
    return lines_of_block(block_depths(outline, *ground.depths), options);
  }
  return {.fan = fan_for_depth(options, region.mean_depth_m),
          .spacing_m = footprint_width_m(options)};
}

RegionLines lines_over(const DepthRegion& region, const PlanarMesh& mesh, const Ground& ground,
                       const PlanOptions& options) {
  const Area outline = region_outline(mesh, region);
  RegionLines result{laid_over(region, outline, ground, options), {}};
  const double spacing = result.laid.spacing_m;
  if (!(spacing > 0.0)) return result;
  check_rows(outline, spacing);
  const Angle azimuth = options.heading.value_or(best_azimuth(outline, spacing));
  result.lines = no_shorter_than(options.least_line_m,
                                 parallel_lines(outline, {.azimuth = azimuth,
                                                          .spacing_m = spacing,
                                                          .inset_m = kLineInset,
                                                          .swath_m = result.laid.swath_m}));
  return result;
}

std::string region_note(std::size_t number, const RegionLines& region, const PlanOptions& options) {
  if (region.laid.spacing_m > 0.0) {
    return fmt::format("region {}: {}", number, spacing_note(region.laid, options));
  }
  return fmt::format(
      "region {} has no lines: the ground {:.4g} m below the sonar is out of its "
      "reach",
      number, region.laid.depth_m);
}

void note_spacing(const std::vector<RegionLines>& regions, const PlanOptions& options,
                  std::vector<std::string>& notes) {
  if (options.rows.swath_by != SwathBy::fan) return;
  for (std::size_t r = 0; r < std::min(regions.size(), kRegionsSaid); ++r) {
    notes.push_back(region_note(r, regions[r], options));
  }
  if (regions.size() <= kRegionsSaid) return;
  notes.push_back(fmt::format("the same rule lays the lines of {}",
                              counted(regions.size() - kRegionsSaid, "more region")));
}

}  // namespace

Plan plan_multi_depth(const Ground& ground, const PlanOptions& options) {
  check_spacing(options.rows);
  Plan plan;
  plan.mesh = planning_mesh(ground, options);
  plan.edges = shared_edges(plan.mesh);
  plan.regions = planning_regions(plan.mesh, plan.edges, ground, options);

  std::vector<RegionLines> regions;
  std::vector<double> lanes, swaths;
  for (const DepthRegion& region : plan.regions.regions) {
    regions.push_back(lines_over(region, plan.mesh, ground, options));
    const BlockLines& laid = regions.back().laid;
    plan.openings.push_back(laid.fan.port + laid.fan.starboard);
    lanes.push_back(laid.spacing_m > 0.0 ? laid.spacing_m : lane_m(options));
    swaths.push_back(wanted_swath_m(laid, options));
  }

  const double radius = options.vehicle.turn_radius_m;
  const JoinCost cost(ground.water, radius);
  const Connector connector = connector_for(ground, options);
  // Turns are wide where they are wider than the nearest rows, and join the farthest ones.
  PlanOptions nearest = options, farthest = options;
  nearest.lane_width_m = *std::min_element(lanes.begin(), lanes.end());
  farthest.lane_width_m = *std::max_element(lanes.begin(), lanes.end());
  BuiltRoute built = shorter_order(nearest, [&](const RowOrder& order) {
    return region_by_region(regions, ground, farthest, connector,
                            [&](const auto& of_region, const auto& at) {
                              return ordered(of_region, order, cost, radius, at);
                            });
  });
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  note_spacing(regions, options, plan.notes);
  if (options.opening == Opening::ping) {
    plan.route = opened_per_ping(plan.route, ground, options, swaths);
  }
  return plan;
}

}  // namespace swathplan

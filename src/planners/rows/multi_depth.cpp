#include "planners/rows/multi_depth.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "planners/rows/back_and_forth.h"
#include "planners/rows/row_order.h"

namespace swathplan {
namespace {

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
BuiltRoute region_by_region(const Plan& plan, const std::vector<std::vector<SurveyLine>>& lines,
                            const Ground& ground, const PlanOptions& options,
                            const Connector& connector, const OrderLines& order) {
  RouteBuilder builder(ground, options, connector);
  std::vector<char> done(lines.size(), 0);
  std::optional<Vec2> at = options.start;
  int number = 1;
  for (std::size_t round = 0; round < lines.size(); ++round) {
    std::size_t pick = lines.size();
    for (std::size_t r = 0; r < lines.size(); ++r) {
      if (done[r] != 0) continue;
      if (pick == lines.size() ||
          (at && nearest_end(lines[r], *at) < nearest_end(lines[pick], *at))) {
        pick = r;
      }
    }
    done[pick] = 1;
    const FanAngles fan = fan_for_depth(options, plan.regions.regions[pick].mean_depth_m);
    for (const SurveyLine& line : order(lines[pick], at)) {
      auto points = line_waypoints(line, number++, fan, options);
      for (Waypoint& point : points) point.region = static_cast<int>(pick);
      builder.add_line(points);
    }
    at = builder.at();
  }
  return builder.built();
}

}  // namespace

Plan plan_multi_depth(const Ground& ground, const PlanOptions& options) {
  const double width = footprint_width_m(options);
  Plan plan;
  plan.mesh = planning_mesh(ground, options);
  plan.edges = shared_edges(plan.mesh);
  plan.regions = planning_regions(plan.mesh, plan.edges, ground, options);

  std::vector<std::vector<SurveyLine>> lines;
  for (const DepthRegion& region : plan.regions.regions) {
    const FanAngles fan = fan_for_depth(options, region.mean_depth_m);
    plan.openings.push_back(fan.port + fan.starboard);
    const Area outline = region_outline(plan.mesh, region);
    const Angle azimuth = options.heading.value_or(best_azimuth(outline, width));
    lines.push_back(
        parallel_lines(outline, {.azimuth = azimuth, .spacing_m = width, .inset_m = kLineInset}));
  }

  const double radius = options.vehicle.turn_radius_m;
  const JoinCost cost(ground.water, radius);
  const Connector connector = connector_for(ground, options);
  BuiltRoute built = shorter_order(options, [&](const RowOrder& order) {
    return region_by_region(plan, lines, ground, options, connector,
                            [&](const auto& of_region, const auto& at) {
                              return ordered(of_region, order, cost, radius, at);
                            });
  });
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
  return plan;
}

}  // namespace swathplan

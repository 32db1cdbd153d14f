#include "planners/multi_depth.h"

#include <algorithm>
#include <limits>

#include "planners/back_and_forth.h"
#include "planners/route_builder.h"
#include "planners/survey_lines.h"

namespace swathplan {
namespace {

double nearest_end(const std::vector<SurveyLine>& lines, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const SurveyLine& line : lines) {
    best = std::min({best, (line.from - p).norm(), (line.to - p).norm()});
  }
  return best;
}

}  // namespace

Plan plan_multi_depth(const PlanningGround& ground, const PlanOptions& options) {
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

  RouteBuilder builder(ground, options);
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
    for (const SurveyLine& line : to_and_fro(lines[pick], at)) {
      auto points = line_waypoints(line, number++, fan, options);
      for (Waypoint& point : points) point.region = static_cast<int>(pick);
      builder.add_line(points);
    }
    at = builder.at();
  }
  plan.route = builder.finish();
  plan.notes = builder.notes();
  if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
  return plan;
}

}  // namespace swathplan

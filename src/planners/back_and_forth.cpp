#include "planners/back_and_forth.h"

#include "planners/route_builder.h"
#include "planners/survey_lines.h"

namespace swathplan {

Plan plan_back_and_forth(const PlanningGround& ground, const PlanOptions& options) {
  check(options);
  const double width = footprint_width_m(options);
  Plan plan;
  plan.mesh = planning_mesh(ground, options);
  plan.edges = shared_edges(plan.mesh);
  const double mean = mean_depth_m(
      depth_regions(plan.mesh, plan.edges, *ground.depths, {.bands = {.count = 1, .limits = {}}}));
  const FanAngles fan = fan_for_depth(options, mean);
  plan.openings = {fan.port + fan.starboard};
  plan.mesh = {};
  plan.edges.clear();

  const Area area = reachable_area(ground);
  const Angle azimuth = options.heading.value_or(best_azimuth(area, width));
  const auto lines = to_and_fro(
      parallel_lines(area, {.azimuth = azimuth, .spacing_m = width, .inset_m = kLineInset}),
      options.start);
  RouteBuilder builder(ground, options);
  int number = 1;
  for (const SurveyLine& line : lines)
    builder.add_line(line_waypoints(line, number++, fan, options));
  plan.route = builder.finish();
  plan.notes = builder.notes();
  if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
  return plan;
}

}  // namespace swathplan

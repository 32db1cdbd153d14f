#include "planners/rows/back_and_forth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/base/error.h"
#include "planners/line_spacing.h"
#include "planners/rows/row_order.h"
#include "planners/rows/survey_lines.h"
#include "planners/simulated.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Shifts of all rows, as shares of their spacing. Centred rows come first and stay where no shift
/// is better.
constexpr std::array kShifts = {0.0, -0.0625, 0.0625, -0.125, 0.125, -0.1875, 0.1875, -0.25, 0.25};

/// What the rows of all placements share.
struct Rows {
  Area area;
  Angle azimuth;
  BlockLines laid;
  JoinCost cost;
  Connector connector;
};

/// Lines as the papers lay them: W apart, with the fan that sweeps W at the mean depth.
BlockLines laid_by_footprint(const Ground& ground, const PlanOptions& options) {
  const PlanarMesh mesh = planning_mesh(ground, options);
  const double mean = mean_depth_m(depth_regions(mesh, shared_edges(mesh), *ground.depths,
                                                 {.bands = {.count = 1, .limits = {}}}));
  return {.fan = fan_for_depth(options, mean), .spacing_m = footprint_width_m(options)};
}

/// @throws InvalidInput where the fan meets no ground.
BlockLines laid_by_fan(const Area& area, const Ground& ground, const PlanOptions& options) {
  const BlockLines laid = lines_of_block(block_depths(area, *ground.depths), options);
  if (laid.spacing_m > 0.0) return laid;
  throw InvalidInput(fmt::format(
      "no line can be spaced by the fan: the ground {:.4g} m below the sonar is out of its reach; "
      "choose another <spacing depth> or <sonar>",
      laid.depth_m));
}

std::vector<SurveyLine> lines_of(const Rows& rows, const PlanOptions& options, double shift) {
  return no_shorter_than(options.least_line_m,
                         parallel_lines(rows.area, {.azimuth = rows.azimuth,
                                                    .spacing_m = rows.laid.spacing_m,
                                                    .inset_m = kLineInset,
                                                    .shift_m = shift * rows.laid.spacing_m,
                                                    .swath_m = rows.laid.swath_m}));
}

Plan sailed(const std::vector<SurveyLine>& lines, const Rows& rows, const Ground& ground,
            const PlanOptions& options) {
  Plan plan;
  plan.heading = rows.azimuth;
  plan.openings = {rows.laid.fan.port + rows.laid.fan.starboard};
  const double radius = options.vehicle.turn_radius_m;
  BuiltRoute built = shorter_order(options, [&](const RowOrder& order) {
    RouteBuilder builder(ground, options, rows.connector);
    int number = 1;
    for (const SurveyLine& line : ordered(lines, order, rows.cost, radius, options.start)) {
      builder.add_line(line_waypoints(line, number++, rows.laid.fan, options));
    }
    return builder.built();
  });
  plan.route = std::move(built.route);
  plan.notes = std::move(built.notes);
  if (options.opening == Opening::ping) {
    plan.route = opened_per_ping(plan.route, ground, options, {wanted_swath_m(rows.laid, options)});
  }
  return plan;
}

std::size_t infeasible_points(const Plan& plan) {
  const auto& points = plan.route.waypoints;
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const Waypoint& w) { return !w.feasible; }));
}

/// The placement with the most worth. A placement with more infeasible waypoints than the centred
/// one is not tried.
Plan best_placed(const Rows& rows, const Ground& ground, const PlanOptions& options) {
  std::vector<Plan> plans;
  std::vector<Outcome> outcomes;
  std::vector<double> shifts;
  const std::size_t lines = lines_of(rows, options, 0.0).size();
  options.watch.phase("placing rows");
  bool ended = false;
  for (const double shift : kShifts) {
    ended = options.watch.ended() && !plans.empty();
    if (ended) break;
    const auto shifted = lines_of(rows, options, shift);
    if (shifted.size() < lines) continue;  // a row has left the area
    Plan plan = sailed(shifted, rows, ground, options);
    if (!plans.empty() && infeasible_points(plan) > infeasible_points(plans.front())) continue;
    outcomes.push_back(simulated_hits(plan.route, ground, options));
    plans.push_back(std::move(plan));
    shifts.push_back(shift * rows.laid.spacing_m);
    options.watch.tried(plans.size(), kShifts.size(), brief(outcomes[pick(outcomes, {}).index]));
  }
  const std::size_t best = pick(outcomes, {}).index;
  plans[best].notes.push_back(
      fmt::format("few rows fit into the area, so their place matters: of {} the simulator chose "
                  "the one {:g} m from the centred rows",
                  counted(plans.size(), "placement"), shifts[best]));
  if (ended) {
    plans[best].notes.push_back(ended_early_note(plans.size(), "placement"));
  }
  return std::move(plans[best]);
}

}  // namespace

Plan plan_back_and_forth(const Ground& ground, const PlanOptions& options) {
  check(options);
  check_spacing(options.rows);
  const bool by_fan = options.rows.swath_by == SwathBy::fan;
  Area area = reachable_area(ground);
  const BlockLines laid =
      by_fan ? laid_by_fan(area, ground, options) : laid_by_footprint(ground, options);
  check_rows(area, laid.spacing_m);
  PlanOptions how = options;
  how.lane_width_m = laid.spacing_m;
  const Angle azimuth = how.heading.value_or(best_azimuth(area, laid.spacing_m));
  const Rows rows{std::move(area), azimuth, laid, JoinCost(ground.water, how.vehicle.turn_radius_m),
                  connector_for(ground, how)};

  const std::vector<SurveyLine> centred = lines_of(rows, how, 0.0);
  const bool few = ground.scene != nullptr && !centred.empty() && centred.back().row < kFewRows;
  Plan plan = few ? best_placed(rows, ground, how) : sailed(centred, rows, ground, how);
  if (by_fan) plan.notes.push_back(spacing_note(laid, how));
  return plan;
}

}  // namespace swathplan

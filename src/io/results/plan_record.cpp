#include "io/results/plan_record.h"

namespace swathplan {
namespace {

std::pair<Vec2, Vec2> ends_of_edge(const Plan& plan, std::uint32_t edge) {
  const SharedEdge& shared = plan.edges[edge];
  const PlanarMesh::Face& face = plan.mesh.faces[shared.face[0]];
  const std::size_t corner = shared.edge[0];
  return {plan.mesh.vertices[face[corner]], plan.mesh.vertices[face[(corner + 1) % face.size()]]};
}

void add_regions(const Plan& plan, PlanRecord& record) {
  record.band_limits_m = plan.regions.band_limits_m;
  for (std::size_t i = 0; i < plan.regions.regions.size(); ++i) {
    const DepthRegion& r = plan.regions.regions[i];
    const Angle opening = plan.openings.at(i);
    record.regions.push_back({.band = r.band,
                              .faces = r.faces.size(),
                              .area_m2 = r.area_m2,
                              .min_depth_m = r.min_depth_m,
                              .mean_depth_m = r.mean_depth_m,
                              .max_depth_m = r.max_depth_m,
                              .fan = {opening / 2.0, opening / 2.0},
                              .outline = region_outline(plan.mesh, r)});
  }
}

void add_gates(const Plan& plan, PlanRecord& record) {
  for (const Gate& g : plan.gates.gates) {
    record.gates.push_back({.edge = ends_of_edge(plan, g.edge),
                            .region_a = g.region_a,
                            .region_b = g.region_b,
                            .slope = g.slope});
  }
  for (const std::uint32_t e : plan.gates.blocked_edges) {
    record.blocked_edges.push_back(ends_of_edge(plan, e));
  }
}

}  // namespace

std::vector<PlanViolation> plan_violations(const Route& route, const Vehicle& vehicle,
                                           const Area& water, const Area& land) {
  std::vector<PlanViolation> list;
  for (const Violation& v : violations(route, vehicle, water, land)) {
    list.push_back(
        {v, std::string(name(route.waypoints[v.first].kind)), reason(v, route, vehicle)});
  }
  return list;
}

PlanRecord plan_record(const Plan& plan, const Sonar& sonar, const Vehicle& vehicle,
                       const Area& water, const Area& land) {
  PlanRecord record;
  add_regions(plan, record);
  add_gates(plan, record);
  record.sonar = sonar;
  record.vehicle = vehicle;
  record.choices = plan.choices;
  record.chosen = plan.chosen;
  record.chosen_why = plan.chosen_why;
  record.heading = plan.heading;
  record.violations = plan_violations(plan.route, vehicle, water, land);
  record.notes = plan.notes;
  return record;
}

}  // namespace swathplan

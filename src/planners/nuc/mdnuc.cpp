#include "planners/nuc/mdnuc.h"

#include "planners/nuc/mesh_choice.h"
#include "planners/nuc/nuc.h"

namespace swathplan {

Plan plan_mdnuc(const Ground& ground, const PlanOptions& options) {
  return best_mesh_plan(ground, options, [&](PlanarMesh mesh, const Connector& connector) {
    Plan plan;
    plan.mesh = std::move(mesh);
    plan.edges = shared_edges(plan.mesh);
    plan.regions = planning_regions(plan.mesh, plan.edges, ground, options);
    plan.gates = choose_gates(plan.mesh, plan.edges, plan.regions, *ground.depths);

    std::vector<char> open(plan.edges.size(), 1);
    for (const std::uint32_t blocked : plan.gates.blocked_edges) open[blocked] = 0;
    std::vector<std::pair<Vec2, Vec2>> blocked_ends;
    for (const std::uint32_t blocked : plan.gates.blocked_edges) {
      const SharedEdge& e = plan.edges[blocked];
      const auto& face = plan.mesh.faces[e.face[0]];
      blocked_ends.emplace_back(plan.mesh.vertices[face[e.edge[0]]],
                                plan.mesh.vertices[face[(e.edge[0] + 1) % face.size()]]);
    }
    std::vector<FanAngles> fans;
    for (const DepthRegion& region : plan.regions.regions) {
      fans.push_back(fan_for_depth(options, region.mean_depth_m));
      plan.openings.push_back(fans.back().port + fans.back().starboard);
    }
    plan.route = skeleton_route(nuc_skeleton(plan.mesh, plan.edges, open), plan.regions.region_of,
                                fans, ground, options, connector, plan.notes, blocked_ends);
    if (options.opening == Opening::ping) plan.route = opened_per_ping(plan.route, ground, options);
    return plan;
  });
}

}  // namespace swathplan

#include "mesh/planar/gates.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/plane/union_find.h"

namespace swathplan {
namespace {

/// Points of the depth profile from one face's centroid over the edge to the other centroid.
constexpr int kProfilePoints = 24;

double depth_at(const DepthQuery& depths, const Vec2& p) {
  const auto found = depths.depth(p);
  return found ? *found : depths.nearest_depth(p);
}

/// Slope of the seafloor across an edge: all rise and fall on the way from centroid to edge
/// midpoint to centroid, over the length of the way. So a wall counts wherever on the way it
/// stands.
Angle slope_across(const PlanarMesh& mesh, const SharedEdge& e, const DepthQuery& depths) {
  const auto& face = mesh.faces[e.face[0]];
  const Vec2 middle =
      0.5 * (mesh.vertices[face[e.edge[0]]] + mesh.vertices[face[(e.edge[0] + 1) % face.size()]]);
  const Vec2 from = face_centroid(mesh, e.face[0]);
  const Vec2 to = face_centroid(mesh, e.face[1]);
  double rise = 0.0;
  double before = depth_at(depths, from);
  for (int k = 1; k <= kProfilePoints; ++k) {
    const double t = 2.0 * k / kProfilePoints;
    const Vec2 p =
        t <= 1.0 ? Vec2(from + t * (middle - from)) : Vec2(middle + (t - 1.0) * (to - middle));
    const double here = depth_at(depths, p);
    rise += std::abs(here - before);
    before = here;
  }
  return Angle::radians(std::atan2(rise, (middle - from).norm() + (to - middle).norm()));
}

double length(const PlanarMesh& mesh, const SharedEdge& e) {
  const auto& face = mesh.faces[e.face[0]];
  return (mesh.vertices[face[e.edge[0]]] - mesh.vertices[face[(e.edge[0] + 1) % face.size()]])
      .norm();
}

}  // namespace

Gates choose_gates(const PlanarMesh& mesh, const std::vector<SharedEdge>& edges,
                   const DepthRegions& regions, const DepthQuery& depths) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Gate> best;
  std::vector<std::uint32_t> between;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t a = regions.region_of[edges[i].face[0]];
    const std::uint32_t b = regions.region_of[edges[i].face[1]];
    if (a == b) continue;
    between.push_back(i);
    const Gate gate{i, std::min(a, b), std::max(a, b), slope_across(mesh, edges[i], depths)};
    const auto [at, fresh] = best.try_emplace({gate.region_a, gate.region_b}, gate);
    if (fresh) continue;
    const bool flatter = gate.slope < at->second.slope;
    const bool same = gate.slope == at->second.slope;
    if (flatter || (same && length(mesh, edges[i]) > length(mesh, edges[at->second.edge]))) {
      at->second = gate;
    }
  }
  std::vector<Gate> candidates;
  for (const auto& [pair, gate] : best) candidates.push_back(gate);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Gate& a, const Gate& b) { return a.slope < b.slope; });

  UnionFind joined(regions.regions.size());
  Gates result;
  for (const Gate& gate : candidates) {
    if (joined.join(gate.region_a, gate.region_b)) result.gates.push_back(gate);
  }
  std::sort(result.gates.begin(), result.gates.end(), [](const Gate& a, const Gate& b) {
    return std::pair(a.region_a, a.region_b) < std::pair(b.region_a, b.region_b);
  });
  for (const std::uint32_t i : between) {
    const bool open = std::any_of(result.gates.begin(), result.gates.end(),
                                  [&](const Gate& gate) { return gate.edge == i; });
    if (!open) result.blocked_edges.push_back(i);
  }
  return result;
}

}  // namespace swathplan

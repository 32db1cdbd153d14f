#include <algorithm>
#include <utility>

#include "mesh/edge_table.h"
#include "mesh/plane/union_find.h"
#include "mesh/repair/mesh_repair.h"

namespace swathplan {
namespace {

/// Walks all loops of border edges. Several loops may pass through one vertex.
std::size_t count_loops(const std::vector<EdgeUse>& border,
                        const std::vector<Seafloor::Face>& faces) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;  // from, to; sorted by from
  steps.reserve(border.size());
  for (const EdgeUse& use : border) {
    const Seafloor::Face& f = faces[use.face];
    steps.emplace_back(f.at(use.corner), f.at((use.corner + 1U) % 3U));
  }
  std::sort(steps.begin(), steps.end());
  std::vector<bool> used(steps.size(), false);
  std::size_t loops = 0;
  for (std::size_t start = 0; start < steps.size(); ++start) {
    if (used[start]) continue;
    ++loops;
    for (std::size_t i = start; i < steps.size() && !used[i];) {
      used[i] = true;
      const std::uint32_t at = steps[i].second;
      auto next = std::lower_bound(steps.begin(), steps.end(), std::pair{at, 0U});
      while (next != steps.end() && next->first == at &&
             used[static_cast<std::size_t>(next - steps.begin())]) {
        ++next;
      }
      if (next == steps.end() || next->first != at) break;
      i = static_cast<std::size_t>(next - steps.begin());
    }
  }
  return loops;
}

bool is_vertical(const Seafloor& s, const Seafloor::Face& f) {
  const Vec3 ab = s.vertices[f[1]] - s.vertices[f[0]];
  const Vec3 ac = s.vertices[f[2]] - s.vertices[f[0]];
  return ab.x() * ac.y() == ab.y() * ac.x();
}

}  // namespace

MeshHealth assess(const Seafloor& seafloor) {
  MeshHealth health;
  health.vertices = seafloor.vertices.size();
  health.faces = seafloor.faces.size();
  const std::vector<EdgeUse> uses = edge_uses(seafloor.faces, seafloor.vertices.size());
  UnionFind parts(seafloor.faces.size());
  std::vector<EdgeUse> border;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) border.push_back(edge.front());
    if (edge.size() > 2) ++health.non_manifold_edges;
    for (std::size_t i = 1; i < edge.size(); ++i) parts.join(edge[0].face, edge[i].face);
  });
  health.components = parts.count();
  health.boundary_loops = count_loops(border, seafloor.faces);
  for (const Seafloor::Face& face : seafloor.faces) {
    health.vertical_faces += is_vertical(seafloor, face) ? 1 : 0;
  }
  return health;
}

}  // namespace swathplan

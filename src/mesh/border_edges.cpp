#include "mesh/border_edges.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "mesh/edge_table.h"

namespace swathplan {

namespace {

using Edge = std::array<std::uint32_t, 2>;

// Edges that belong to one face only if vertices are told apart by index. Sorted by lower vertex,
// then by face.
std::vector<Edge> unpaired_by_index(const Seafloor& seafloor) {
  std::vector<EdgeUse> single;
  for_each_edge(edge_uses(seafloor.faces, seafloor.vertices.size()), [&](const auto& edge) {
    if (edge.size() == 1) single.push_back(edge.front());
  });
  std::sort(single.begin(), single.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tuple(a.low, a.face, a.corner) < std::tuple(b.low, b.face, b.corner);
  });
  std::vector<Edge> result;
  result.reserve(single.size());
  for (const EdgeUse& use : single) {
    result.push_back(use.ascends ? Edge{use.low, use.high} : Edge{use.high, use.low});
  }
  return result;
}

using Position = std::tuple<double, double, double>;

Position position(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

std::vector<Edge> border_edges(const Seafloor& seafloor) {
  std::vector<Edge> edges = unpaired_by_index(seafloor);
  // Few are left. They are paired by position.
  std::map<std::pair<Position, Position>, int> uses;
  const auto key = [&](const Edge& e) {
    Position a = position(seafloor.vertices[e[0]]);
    Position b = position(seafloor.vertices[e[1]]);
    if (b < a) std::swap(a, b);
    return std::pair{a, b};
  };
  for (const Edge& e : edges) ++uses[key(e)];
  std::erase_if(edges, [&](const Edge& e) { return uses[key(e)] > 1; });
  return edges;
}

}  // namespace swathplan

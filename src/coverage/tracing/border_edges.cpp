#include <algorithm>
#include <map>
#include <tuple>

#include "coverage/tracing/border_edges_internal.h"

namespace swathplan {

namespace {

using Edge = std::array<std::uint32_t, 2>;

// A half-edge seen from its lower vertex.
struct HalfEdge {
  std::uint32_t high;
  bool ascending;
};

// Edges that occur in one direction only, told apart by vertex index.
std::vector<Edge> unpaired_by_index(const Seafloor& seafloor) {
  std::vector<std::uint32_t> first(seafloor.vertices.size() + 1, 0);
  for (const Seafloor::Face& f : seafloor.faces) {
    for (int k = 0; k < 3; ++k) ++first[std::min(f[k], f[(k + 1) % 3]) + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<HalfEdge> bucket(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const Seafloor::Face& f : seafloor.faces) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = f[k];
      const std::uint32_t b = f[(k + 1) % 3];
      bucket[next[std::min(a, b)]++] = {std::max(a, b), a < b};
    }
  }
  std::vector<Edge> result;
  for (std::uint32_t low = 0; low + 1 < first.size(); ++low) {
    for (std::uint32_t i = first[low]; i < first[low + 1]; ++i) {
      std::uint32_t uses = 0;
      for (std::uint32_t j = first[low]; j < first[low + 1]; ++j) {
        uses += bucket[j].high == bucket[i].high ? 1U : 0U;
      }
      if (uses != 1) continue;
      result.push_back(bucket[i].ascending ? Edge{low, bucket[i].high} : Edge{bucket[i].high, low});
    }
  }
  return result;
}

using Position = std::tuple<double, double, double>;

Position position(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

std::vector<Edge> border_edges(const Seafloor& seafloor) {
  std::vector<Edge> edges = unpaired_by_index(seafloor);
  // The few that are left: pair them by position.
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

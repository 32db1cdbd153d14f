#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "mesh/error.h"
#include "mesh/planar_mesh.h"

namespace swathplan {

std::vector<SharedEdge> shared_edges(const PlanarMesh& mesh) {
  struct Side {
    std::uint32_t face, edge;
  };
  // Keyed by the directed edge in 64 bits: no overflow however many vertices there are.
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(a) << 32) | b;
  };
  std::unordered_map<std::uint64_t, Side> side;
  std::size_t corners = 0;
  for (const auto& face : mesh.faces) corners += face.size();
  side.reserve(corners);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (std::uint32_t k = 0; k < face.size(); ++k) {
      if (!side.try_emplace(key(face[k], face[(k + 1) % face.size()]), Side{f, k}).second) {
        throw InvalidInput(fmt::format(
            "planar mesh: edge {}-{} of face {} runs the same way in another face; faces must be "
            "counter-clockwise and share an edge by two at most",
            face[k], face[(k + 1) % face.size()], f));
      }
    }
  }
  std::vector<SharedEdge> edges;
  edges.reserve(corners / 2);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (std::uint32_t k = 0; k < face.size(); ++k) {
      const auto other = side.find(key(face[(k + 1) % face.size()], face[k]));
      if (other == side.end() || other->second.face <= f) continue;
      edges.push_back({{f, other->second.face}, {k, other->second.edge}});
    }
  }
  return edges;
}

std::vector<std::uint32_t> connected_parts(const PlanarMesh& mesh,
                                           const std::vector<SharedEdge>& edges) {
  std::vector<std::uint32_t> parent(mesh.faces.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (const SharedEdge& e : edges) {
    const std::uint32_t a = root(e.face[0]);
    const std::uint32_t b = root(e.face[1]);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> part(mesh.faces.size());
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    part[f] = root(f) == f ? count++ : part[root(f)];
  }
  return part;
}

double face_area(const PlanarMesh& mesh, std::uint32_t face) {
  Ring ring;
  for (const std::uint32_t v : mesh.faces[face]) ring.push_back(mesh.vertices[v]);
  return std::abs(signed_area(ring));
}

Vec2 face_centroid(const PlanarMesh& mesh, std::uint32_t face) {
  Vec2 sum = Vec2::Zero();
  for (const std::uint32_t v : mesh.faces[face]) sum += mesh.vertices[v];
  return sum / static_cast<double>(mesh.faces[face].size());
}

}  // namespace swathplan

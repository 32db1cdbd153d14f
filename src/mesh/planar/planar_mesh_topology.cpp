#include <fmt/format.h>

#include <algorithm>

#include "mesh/base/error.h"
#include "mesh/planar/planar_mesh.h"
#include "mesh/plane/union_find.h"

namespace swathplan {

namespace {

/// Every side of every face, listed at the vertex where it begins.
struct Sides {
  struct Side {
    std::uint32_t to, face, edge;
  };
  std::vector<std::uint32_t> start;
  std::vector<Side> items;

  explicit Sides(const PlanarMesh& mesh) : start(mesh.vertices.size() + 1, 0) {
    for (const auto& face : mesh.faces) {
      for (const std::uint32_t v : face) ++start[v + 1];
    }
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    items.resize(start.back());
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& face = mesh.faces[f];
      for (std::uint32_t k = 0; k < face.size(); ++k) {
        items[at[face[k]]++] = {face[k + 1 < face.size() ? k + 1 : 0], f, k};
      }
    }
  }

  /// The sides from a to b, one in a sound mesh.
  template <class Visit>
  void from_to(std::uint32_t a, std::uint32_t b, Visit&& visit) const {
    for (std::uint32_t i = start[a]; i < start[a + 1]; ++i) {
      if (items[i].to == b) visit(items[i]);
    }
  }
};

}  // namespace

std::vector<SharedEdge> shared_edges(const PlanarMesh& mesh) {
  const Sides sides(mesh);
  std::vector<SharedEdge> edges;
  edges.reserve(sides.items.size() / 2);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (std::uint32_t k = 0; k < face.size(); ++k) {
      const std::uint32_t a = face[k];
      const std::uint32_t b = face[k + 1 < face.size() ? k + 1 : 0];
      sides.from_to(a, b, [&](const Sides::Side& same) {
        if (same.face == f && same.edge == k) return;
        throw InvalidInput(fmt::format(
            "planar mesh: edge {}-{} of face {} runs the same way in another face; faces must be "
            "counter-clockwise and share an edge by two at most",
            a, b, f));
      });
      sides.from_to(b, a, [&](const Sides::Side& twin) {
        if (twin.face > f) edges.push_back({{f, twin.face}, {k, twin.edge}});
      });
    }
  }
  return edges;
}

std::vector<std::uint32_t> connected_parts(const PlanarMesh& mesh,
                                           const std::vector<SharedEdge>& edges) {
  UnionFind parts(mesh.faces.size());
  for (const SharedEdge& e : edges) parts.join(e.face[0], e.face[1]);
  return parts.numbered();
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

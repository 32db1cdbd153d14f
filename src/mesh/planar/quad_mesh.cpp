#include "mesh/planar/quad_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "mesh/base/error.h"
#include "mesh/planar/face_layout.h"
#include "mesh/planar/face_merging.h"
#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using QuadCdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_predicates_tag>;

/// A piece under the first share of a cell joins a neighbour, unless both together exceed the
/// second.
constexpr double kSmallPiece = 0.4;
constexpr double kLargestPiece = 1.6;
/// The longest face, in sides: two cells in a row, measured from corner to corner.
constexpr double kLongestPiece = 2.25;

/// Nearer to the outline than this only an exact test tells inside from outside, metres.
constexpr double kLookClosely = 10.0 * AreaQuery::kOnOutline;

/// The pieces of cells as triangles, and the edges between them that are not on a lattice line.
struct Pieces {
  PlanarMesh mesh;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inner_edges;
};

void insert_ring(QuadCdt& cdt, const Ring& ring) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    cdt.insert_constraint(QuadCdt::Point(ring[j].x(), ring[j].y()),
                          QuadCdt::Point(ring[i].x(), ring[i].y()));
  }
}

/// Inserts the lines of the lattice across the polygon and a step beyond, so that their ends never
/// lie on the outline. Each line is inserted from node to node. Where a piece meets the outline
/// CGAL rounds, and the rest of a longer piece would miss the nodes behind.
void insert_lattice(QuadCdt& cdt, const Box2& box, double side) {
  const Vec2 size = box.size();
  const Vec2 step(fitted_step(size.x(), side), fitted_step(size.y(), side));
  const auto columns = static_cast<int>(std::round(size.x() / step.x()));
  const auto rows = static_cast<int>(std::round(size.y() / step.y()));
  const auto node = [&](int c, int r) {
    return QuadCdt::Point(box.min.x() + step.x() * c, box.min.y() + step.y() * r);
  };
  // Nodes 1 to n - 1 lie inside the box, the ones after -1 and before n + 1 on its border.
  const auto after = [](int k, int n) { return k == -1 ? 1 : k == n - 1 ? n + 1 : k + 1; };
  for (int c = 1; c < columns; ++c) {
    for (int r = -1; r <= rows; r = after(r, rows)) {
      cdt.insert_constraint(node(c, r), node(c, after(r, rows)));
    }
  }
  for (int r = 1; r < rows; ++r) {
    for (int c = -1; c <= columns; c = after(c, columns)) {
      cdt.insert_constraint(node(c, r), node(after(c, columns), r));
    }
  }
}

Vec2 position(const QuadCdt::Vertex_handle& v) { return {v->point().x(), v->point().y()}; }

/// The triangles inside, sorted by place, since CGAL's own order depends on memory addresses.
std::vector<QuadCdt::Face_handle> inside_triangles(const QuadCdt& cdt, const Area& part) {
  const AreaQuery query(part);
  std::vector<std::pair<Vec2, QuadCdt::Face_handle>> found;
  for (const QuadCdt::Face_handle f : cdt.finite_face_handles()) {
    const Vec2 centre =
        (position(f->vertex(0)) + position(f->vertex(1)) + position(f->vertex(2))) / 3.0;
    const bool inside =
        query.distance(centre) > kLookClosely ? query.contains(centre) : contains(part, centre);
    if (inside) found.emplace_back(centre, f);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first.y(), a.first.x()) < std::pair(b.first.y(), b.first.x());
  });
  std::vector<QuadCdt::Face_handle> result;
  result.reserve(found.size());
  for (const auto& [centre, f] : found) result.push_back(f);
  return result;
}

/// The vertices of the pieces. Vertices nearer than kSame are one: a line through a corner of the
/// outline meets it only up to a rounding error.
class Vertices {
 public:
  explicit Vertices(PlanarMesh& mesh) : mesh_(mesh) {}

  std::uint32_t index(const Vec2& p) {
    const Cell cell{std::llround(p.x() / kSame), std::llround(p.y() / kSame)};
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        const auto at = known_.find({cell.first + x, cell.second + y});
        if (at != known_.end()) return at->second;
      }
    }
    known_[cell] = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(p);
    return known_[cell];
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  static constexpr double kSame = 1e-6;  ///< metres

  PlanarMesh& mesh_;
  std::map<Cell, std::uint32_t> known_;
};

Pieces cut(const Polygon& polygon, double side) {
  const Area part{polygon};
  QuadCdt cdt;
  insert_ring(cdt, polygon.outer);
  for (const Ring& hole : polygon.holes) insert_ring(cdt, hole);
  insert_lattice(cdt, extent(part), side);
  Pieces pieces;
  Vertices vertices(pieces.mesh);
  for (const QuadCdt::Face_handle f : inside_triangles(cdt, part)) {
    std::array<std::uint32_t, 3> corner{};
    for (int k = 0; k < 3; ++k) {
      corner[static_cast<std::size_t>(k)] = vertices.index(position(f->vertex(k)));
    }
    const auto [a, b, c] = corner;
    if (a == b || b == c || c == a) continue;
    pieces.mesh.faces.push_back({a, b, c});
    if (!f->is_constrained(0) && b < c) pieces.inner_edges.emplace_back(b, c);
    if (!f->is_constrained(1) && c < a) pieces.inner_edges.emplace_back(c, a);
    if (!f->is_constrained(2) && a < b) pieces.inner_edges.emplace_back(a, b);
  }
  return pieces;
}

/// The polygon in faces, in the lattice's frame.
PlanarMesh faces_of(const Polygon& polygon, double side) {
  Pieces pieces = cut(polygon, side);
  const auto length = [&vertices = pieces.mesh.vertices](const auto& edge) {
    return (vertices[edge.first] - vertices[edge.second]).norm();
  };
  std::stable_sort(pieces.inner_edges.begin(), pieces.inner_edges.end(),
                   [&](const auto& a, const auto& b) { return length(a) > length(b); });
  FaceMerging merging(pieces.mesh);
  merging.take_away(pieces.inner_edges);
  merging.join_small({.small_m2 = kSmallPiece * side * side,
                      .largest_m2 = kLargestPiece * side * side,
                      .longest_m = kLongestPiece * side});
  return merging.result();
}

}  // namespace

PlanarMesh quad_mesh(const Area& area, const QuadMeshOptions& options) {
  if (!(options.side_m > 0.0)) throw UsageError("the faces' side must be above 0 metres");
  const FaceLayout layout = face_layout(area, options.side_m, options.turn);
  PlanarMesh mesh;
  for (const Polygon& polygon : layout.area) {
    const PlanarMesh part = faces_of(polygon, options.side_m);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec2& p : part.vertices) mesh.vertices.push_back(rotated(p, layout.turned_by));
    for (PlanarMesh::Face face : part.faces) {
      for (std::uint32_t& v : face) v += first;
      mesh.faces.push_back(std::move(face));
    }
  }
  require_faces(mesh);
  return mesh;
}

}  // namespace swathplan

#include "mesh/planar/planar_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/base/error.h"
#include "mesh/planar/face_layout.h"
#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Tds = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Mesher = CGAL::Delaunay_mesher_2<Cdt, Criteria>;

/// Lattice nodes nearer to the outline than this share of the lattice step are left out.
constexpr double kLatticeKeepOff = 0.42;
/// A face with an edge longer than this, in lattice steps times the square root of 2, is refined.
constexpr double kLargestEdge = 1.6;

/// The constrained Delaunay triangulation of an area: outline, then lattice, then refinement.
class AreaTriangulation {
 public:
  AreaTriangulation(const Area& area, double step) : area_(area), step_(step) {}

  void insert_outline() {
    for (const Polygon& polygon : area_) {
      insert_ring(polygon.outer);
      for (const Ring& hole : polygon.holes) insert_ring(hole);
    }
  }

  void insert_lattice(const Polygon& polygon) {
    const Area part{polygon};
    const Box2 box = extent(part);
    const Vec2 size = box.size();
    const Vec2 step(fitted_step(size.x(), step_), fitted_step(size.y(), step_));
    const auto columns = static_cast<int>(std::round(size.x() / step.x()));
    const auto rows = static_cast<int>(std::round(size.y() / step.y()));
    const AreaQuery query(part);
    for (int r = 1; r < rows; ++r) {
      for (int c = 1; c < columns; ++c) {
        const Vec2 p = box.min + Vec2(step.x() * c, step.y() * r);
        if (!query.contains(p) || query.distance(p) < kLatticeKeepOff * step_) continue;
        cdt_.insert(Cdt::Point(p.x(), p.y()));
      }
    }
  }

  /// Splits faces that are too large. Holes, and the ground between parts, stay out of the mesh.
  void refine() {
    Mesher mesher(cdt_);
    const AreaQuery query(area_);
    std::vector<Cdt::Point> outside;
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      const Cdt::Point c = CGAL::centroid(cdt_.triangle(f));
      if (!query.contains({c.x(), c.y()})) outside.push_back(c);
    }
    mesher.set_seeds(outside.begin(), outside.end(), false);
    // Only the size is bounded. A bound on the shape would fill the strips along quays with small
    // faces, and every face makes the path longer.
    mesher.set_criteria(Criteria(0.0, kLargestEdge * step_ * std::numbers::sqrt2));
    mesher.refine_mesh();
  }

  [[nodiscard]] PlanarMesh mesh(Angle angle) const {
    PlanarMesh result;
    // Faces are sorted by place, since CGAL's own order depends on memory addresses.
    struct Item {
      std::array<Vec2, 3> corner;
      Vec2 centre;
    };
    std::vector<Item> items;
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      if (!f->is_in_domain()) continue;
      Item item;
      for (int k = 0; k < 3; ++k) {
        const auto& p = f->vertex(k)->point();
        item.corner[static_cast<std::size_t>(k)] = Vec2(p.x(), p.y());
      }
      item.centre = (item.corner[0] + item.corner[1] + item.corner[2]) / 3.0;
      items.push_back(item);
    }
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return std::pair(a.centre.y(), a.centre.x()) < std::pair(b.centre.y(), b.centre.x());
    });
    std::map<std::pair<double, double>, std::uint32_t> vertex;
    for (const Item& item : items) {
      PlanarMesh::Face face;
      for (const Vec2& p : item.corner) {
        const auto [at, fresh] =
            vertex.try_emplace({p.x(), p.y()}, static_cast<std::uint32_t>(result.vertices.size()));
        if (fresh) result.vertices.push_back(rotated(p, angle));
        face.push_back(at->second);
      }
      result.faces.push_back(std::move(face));
    }
    return result;
  }

 private:
  void insert_ring(const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      insert_edge(ring[j], ring[i]);
    }
  }

  void insert_edge(const Vec2& a, const Vec2& b) {
    const auto parts = static_cast<int>(std::max(1.0, std::round((b - a).norm() / step_)));
    Cdt::Vertex_handle before = cdt_.insert(Cdt::Point(a.x(), a.y()));
    for (int k = 1; k <= parts; ++k) {
      const Vec2 p = k == parts ? b : Vec2(a + (b - a) * (static_cast<double>(k) / parts));
      const Cdt::Vertex_handle here = cdt_.insert(Cdt::Point(p.x(), p.y()));
      if (here != before) cdt_.insert_constraint(before, here);
      before = here;
    }
  }

  const Area& area_;
  double step_;
  Cdt cdt_;
};

}  // namespace

PlanarMesh planar_mesh(const Area& area, const PlanarMeshOptions& options) {
  if (!(options.hypotenuse_m > 0.0))
    throw UsageError("the faces' hypotenuse must be above 0 metres");
  const FaceLayout layout = face_layout(area, options.hypotenuse_m, options.turn);
  const Area& turned = layout.area;
  AreaTriangulation triangulation(turned, options.hypotenuse_m / std::numbers::sqrt2);
  triangulation.insert_outline();
  for (const Polygon& polygon : turned) triangulation.insert_lattice(polygon);
  triangulation.refine();
  PlanarMesh mesh = triangulation.mesh(layout.turned_by);
  require_faces(mesh);
  return mesh;
}

}  // namespace swathplan

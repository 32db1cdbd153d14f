#include "mesh/planar_mesh.h"

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

#include "mesh/area_query.h"
#include "mesh/error.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Tds = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
using Mesher = CGAL::Delaunay_mesher_2<Cdt, Criteria>;

/// Shares of the hypotenuse.
constexpr double kOutlineTolerance = 0.02;  ///< details of the outline that faces do not follow
constexpr double kLatticeKeepOff = 0.42;    ///< of the lattice step: nodes nearer the outline go
constexpr double kLargestEdge = 1.6;        ///< of the lattice step, before a face is refined
constexpr int kDirectionBins = 180;         ///< half-degree bins over a right angle

/// The direction that most of the outline follows, modulo a right angle.
double main_direction(const Area& area) {
  std::vector<double> weight(kDirectionBins, 0.0);
  std::vector<double> moment(kDirectionBins, 0.0);
  const double bin = 0.5 * std::numbers::pi / kDirectionBins;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2 d = ring[i] - ring[j];
      double angle =
          std::fmod(std::atan2(d.y(), d.x()) + 2.0 * std::numbers::pi, 0.5 * std::numbers::pi);
      // A hair below a right angle is the same direction as a hair above zero.
      if (angle > 0.5 * std::numbers::pi - 0.5 * bin) angle -= 0.5 * std::numbers::pi;
      const auto k = static_cast<std::size_t>(std::max(0.0, std::floor(angle / bin + 0.5))) %
                     static_cast<std::size_t>(kDirectionBins);
      weight[k] += d.norm();
      moment[k] += d.norm() * angle;
    }
  };
  for (const Polygon& polygon : area) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  const auto best =
      static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
  return weight[best] > 0.0 ? moment[best] / weight[best] : 0.0;
}

Vec2 rotate(const Vec2& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

Ring rotated(const Ring& ring, double angle) {
  Ring result;
  result.reserve(ring.size());
  for (const Vec2& p : ring) result.push_back(rotate(p, angle));
  return result;
}

Area rotated(const Area& area, double angle) {
  Area result;
  for (const Polygon& polygon : area) {
    Polygon turned{rotated(polygon.outer, angle), {}};
    for (const Ring& hole : polygon.holes) turned.holes.push_back(rotated(hole, angle));
    result.push_back(std::move(turned));
  }
  return result;
}

/// The area whose outline the faces follow: inside the given one, details under the tolerance
/// gone, so that a staircase of grid cells does not make a staircase of faces. Channels that the
/// inset would close are put back with a finer one.
Area outline_for_faces(const Area& area, double hypotenuse) {
  const double fine = 0.1 * kOutlineTolerance * hypotenuse;
  const double coarse = kOutlineTolerance * hypotenuse;
  const auto inside = [&](double e) { return simplify(offset(area, -e), 0.9 * e); };
  Area result = inside(coarse);
  Area lost = subtract(area, offset(result, 3.0 * coarse));
  if (!lost.empty()) {
    result = unite(result, intersect(inside(fine), offset(lost, 4.0 * coarse)));
    result = simplify(result, 0.5 * fine);
  }
  return intersect(result, area);
}

/// Step that fits a whole number of times into `length`, near `wanted`.
double fitted_step(double length, double wanted) {
  return length / std::max(1.0, std::round(length / wanted));
}

class Builder {
 public:
  Builder(const Area& area, double step) : area_(area), step_(step) {}

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

  /// Splits faces that are too large; holes and what lies between parts stay out of the mesh.
  void refine() {
    Mesher mesher(cdt_);
    const AreaQuery query(area_);
    std::vector<Cdt::Point> outside;
    for (auto f = cdt_.finite_faces_begin(); f != cdt_.finite_faces_end(); ++f) {
      const Cdt::Point c = CGAL::centroid(cdt_.triangle(f));
      if (!query.contains({c.x(), c.y()})) outside.push_back(c);
    }
    mesher.set_seeds(outside.begin(), outside.end(), false);
    // No bound on the shape: it would fill the strips along quays with small faces, and every face
    // costs path. Size alone is bounded.
    mesher.set_criteria(Criteria(0.0, kLargestEdge * step_ * std::numbers::sqrt2));
    mesher.refine_mesh();
  }

  [[nodiscard]] PlanarMesh mesh(double angle) const {
    PlanarMesh result;
    // Faces in a geometric order: CGAL's own order depends on addresses.
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
        if (fresh) result.vertices.push_back(rotate(p, angle));
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
  if (area.empty()) throw InvalidInput("the survey area is empty: there is nothing to mesh");
  const double angle =
      main_direction(simplify(area, kOutlineTolerance * options.hypotenuse_m)) + options.turn.rad();
  const Area turned = rotated(outline_for_faces(area, options.hypotenuse_m), -angle);
  Builder builder(turned, options.hypotenuse_m / std::numbers::sqrt2);
  builder.insert_outline();
  for (const Polygon& polygon : turned) builder.insert_lattice(polygon);
  builder.refine();
  PlanarMesh mesh = builder.mesh(angle);
  if (mesh.faces.empty()) {
    throw InvalidInput(
        "the survey area is too small for a single face; use a finer --resolution or a larger "
        "area");
  }
  return mesh;
}

}  // namespace swathplan

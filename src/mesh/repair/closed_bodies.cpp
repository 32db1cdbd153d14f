#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "mesh/edge_table.h"
#include "mesh/plane/segments.h"
#include "mesh/plane/union_find.h"
#include "mesh/repair/closed_bodies_internal.h"

namespace swathplan {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Face = Seafloor::Face;

/// Which parts are closed, and whether the faces of each already look to one side.
struct Bodies {
  UnionFind parts;
  std::vector<bool> closed;  ///< by the lowest face of the part
  bool all_agree = true;     ///< true: no closed part holds two faces of opposite sense
  bool any_closed = false;
};

Bodies find_bodies(const Seafloor& mesh) {
  Bodies bodies{UnionFind(mesh.faces.size()), std::vector<bool>(mesh.faces.size(), true)};
  const std::vector<EdgeUse> uses = edge_uses(mesh.faces, mesh.vertices.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    for (std::size_t i = 1; i < edge.size(); ++i) bodies.parts.join(edge[0].face, edge[i].face);
  });
  std::vector<bool> odd(mesh.faces.size(), false);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const std::uint32_t part = bodies.parts.find(edge[0].face);
    if (edge.size() == 1) bodies.closed[part] = false;
    const auto up = std::count_if(edge.begin(), edge.end(), [](auto& u) { return u.ascends; });
    if (2 * static_cast<std::size_t>(up) != edge.size()) odd[part] = true;
  });
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (bodies.parts.find(f) != f || !bodies.closed[f]) continue;
    bodies.any_closed = true;
    if (odd[f]) bodies.all_agree = false;
  }
  return bodies;
}

void make_faces_agree(Seafloor& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  std::vector<std::vector<std::size_t>> polygons;
  for (const Face& f : mesh.faces) polygons.push_back({f[0], f[1], f[2]});
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons);
  mesh.vertices.clear();
  for (const Kernel::Point_3& p : points) mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i)
      mesh.faces[f].at(i) = static_cast<std::uint32_t>(polygons[f][i]);
  }
}

double plan_area_twice(const Seafloor& mesh, const Face& f) {
  const Vec3 ab = mesh.vertices[f[1]] - mesh.vertices[f[0]];
  const Vec3 ac = mesh.vertices[f[2]] - mesh.vertices[f[0]];
  return cross(ab.head<2>(), ac.head<2>());
}

/// Six times the volume that each closed part encloses, positive where its faces look outwards.
std::vector<double> signed_volumes(const Seafloor& mesh, Bodies& bodies) {
  std::vector<double> volume(mesh.faces.size(), 0.0);
  const Vec3 middle = mesh.vertices.front();
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const Face& face = mesh.faces[f];
    const Vec3 a = mesh.vertices[face[0]] - middle;
    const Vec3 b = mesh.vertices[face[1]] - middle;
    const Vec3 c = mesh.vertices[face[2]] - middle;
    volume[bodies.parts.find(f)] += a.dot(b.cross(c));
  }
  return volume;
}

/// Drops walls that hang in the air: those that have lost a neighbour across an edge with a length
/// in plan. This goes on up the wall. Upright edges do not count, since inner walls meet outer ones
/// there.
void drop_hanging_walls(const Seafloor& mesh, std::vector<bool>& dropped) {
  const std::vector<EdgeUse> uses = edge_uses(mesh.faces, mesh.vertices.size());
  std::vector<std::vector<std::uint32_t>> walls_beside(mesh.faces.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const Vec2 plan = mesh.vertices[edge[0].low].head<2>() - mesh.vertices[edge[0].high].head<2>();
    if (edge.size() != 2 || plan.isZero(0.0)) return;
    walls_beside[edge[0].face].push_back(edge[1].face);
    walls_beside[edge[1].face].push_back(edge[0].face);
  });
  std::vector<std::uint32_t> queue;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (dropped[f]) queue.push_back(f);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const std::uint32_t f : walls_beside[queue[i]]) {
      if (dropped[f] || plan_area_twice(mesh, mesh.faces[f]) != 0.0) continue;
      dropped[f] = true;
      queue.push_back(f);
    }
  }
}

}  // namespace

std::size_t drop_undersides(Seafloor& mesh) {
  Bodies bodies = find_bodies(mesh);
  if (bodies.any_closed && !bodies.all_agree) {
    make_faces_agree(mesh);
    bodies = find_bodies(mesh);
  }
  if (!bodies.any_closed) return 0;
  const std::vector<double> volume = signed_volumes(mesh, bodies);
  std::vector<bool> dropped(mesh.faces.size(), false);
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t part = bodies.parts.find(f);
    const double outward = volume[part] < 0.0 ? -1.0 : 1.0;
    dropped[f] = bodies.closed[part] && outward * plan_area_twice(mesh, mesh.faces[f]) < 0.0;
  }
  drop_hanging_walls(mesh, dropped);
  std::uint32_t kept = 0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (!dropped[f]) mesh.faces[kept++] = mesh.faces[f];
  }
  const std::size_t taken = mesh.faces.size() - kept;
  mesh.faces.resize(kept);
  return taken;
}

}  // namespace swathplan

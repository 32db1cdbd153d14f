#include "mesh/repair/mesh_repair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/base/error.h"
#include "mesh/edge_table.h"
#include "mesh/plane/union_find.h"
#include "mesh/repair/closed_bodies_internal.h"
#include "mesh/repair/needles_internal.h"

namespace swathplan {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Face = Seafloor::Face;

/// A sheet stands on edge if its plan area is under this share of its true area. Rounding alone
/// leaves a share of about 1e-16 to 1e-12.
constexpr double kVerticalSheetShare = 1e-9;

Kernel::Point_3 point3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Kernel::Point_2 point2(const Vec3& v) { return {v.x(), v.y()}; }

void check(const Seafloor& soup) {
  if (soup.faces.empty()) {
    throw InvalidInput("the mesh holds no faces; a seafloor needs triangles, not points alone");
  }
  for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
    if (!soup.vertices[i].allFinite()) {
      throw InvalidInput(fmt::format(
          "vertex {} has a coordinate that is not a finite number; remove or mend it", i + 1));
    }
  }
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (const std::uint32_t v : soup.faces[f]) {
      if (v >= soup.vertices.size()) {
        throw InvalidInput(
            fmt::format("face {} asks for vertex {}, but there are only {} vertices; "
                        "the file is truncated or garbled",
                        f + 1, v + 1ULL, soup.vertices.size()));
      }
    }
  }
}

/// Merges equal points, then drops faces with a corner twice, then merges equal faces (CGAL).
void weld(Seafloor& s, MeshHealth& health) {
  std::vector<Kernel::Point_3> points;
  points.reserve(s.vertices.size());
  for (const Vec3& v : s.vertices) points.push_back(point3(v));
  std::vector<std::vector<std::size_t>> polygons;
  polygons.reserve(s.faces.size());
  for (const Face& f : s.faces) polygons.push_back({f[0], f[1], f[2]});
  health.duplicate_vertices = pmp::merge_duplicate_points_in_polygon_soup(points, polygons);
  s.vertices.clear();
  for (const Kernel::Point_3& p : points) s.vertices.emplace_back(p.x(), p.y(), p.z());
  health.degenerate_faces = std::erase_if(polygons, [](const std::vector<std::size_t>& p) {
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
  });
  health.duplicate_faces = pmp::merge_duplicate_polygons_in_polygon_soup(points, polygons);
  s.faces.clear();
  for (const std::vector<std::size_t>& p : polygons) {
    s.faces.push_back({static_cast<std::uint32_t>(p[0]), static_cast<std::uint32_t>(p[1]),
                       static_cast<std::uint32_t>(p[2])});
  }
}

CGAL::Orientation plan_orientation(const Seafloor& s, const Face& f) {
  return CGAL::orientation(point2(s.vertices[f[0]]), point2(s.vertices[f[1]]),
                           point2(s.vertices[f[2]]));
}

/// Orients walls, which have no upper side. Each takes the sense of a neighbour that is oriented,
/// breadth first. `oriented`: one flag a face.
void orient_walls(Seafloor& s, std::vector<bool> oriented, MeshHealth& health) {
  const std::vector<EdgeUse> uses = edge_uses(s.faces, s.vertices.size());
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(s.faces.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const bool agree = edge[0].ascends != edge[1].ascends;
    for (const std::size_t k : {0U, 1U}) {
      if (!oriented[edge[1 - k].face]) {
        neighbours[edge[k].face].emplace_back(edge[1 - k].face, agree);
      }
    }
  });
  std::vector<std::uint32_t> queue;
  for (std::uint32_t f = 0; f < s.faces.size(); ++f) {
    if (oriented[f] && !neighbours[f].empty()) queue.push_back(f);
  }
  std::vector<bool> flipped(s.faces.size(), false);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const auto& [wall, agree] : neighbours[queue[i]]) {
      if (oriented[wall]) continue;
      oriented[wall] = true;
      flipped[wall] = agree == flipped[queue[i]];
      queue.push_back(wall);
    }
  }
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    if (!flipped[f]) continue;
    std::swap(s.faces[f][1], s.faces[f][2]);
    ++health.flipped_faces;
  }
}

void orient_up(Seafloor& s, MeshHealth& health) {
  std::vector<bool> oriented(s.faces.size(), true);
  bool has_walls = false;
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const CGAL::Orientation turn = plan_orientation(s, s.faces[f]);
    if (turn == CGAL::COLLINEAR) {
      oriented[f] = false;
      has_walls = true;
    } else if (turn == CGAL::CLOCKWISE) {
      std::swap(s.faces[f][1], s.faces[f][2]);
      ++health.flipped_faces;
    }
  }
  if (has_walls) orient_walls(s, std::move(oriented), health);
}

/// At a vertex of a non-manifold edge, gives each fan of faces a vertex of its own. So every edge
/// is left with at most two faces.
void split_non_manifold(Seafloor& s, MeshHealth& health) {
  const std::vector<EdgeUse> uses = edge_uses(s.faces, s.vertices.size());
  std::vector<bool> is_split(s.vertices.size(), false);
  UnionFind corners(3 * s.faces.size());
  const auto corner_at = [&](const EdgeUse& use, std::uint32_t vertex) {
    const std::uint32_t next = (use.corner + 1U) % 3U;
    return 3 * use.face + (s.faces[use.face].at(use.corner) == vertex ? use.corner : next);
  };
  const auto join = [&](const EdgeUse& a, const EdgeUse& b) {
    corners.join(corner_at(a, a.low), corner_at(b, b.low));
    corners.join(corner_at(a, a.high), corner_at(b, b.high));
  };
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) join(edge[0], edge[1]);
    if (edge.size() < 3) return;
    ++health.non_manifold_edges;
    is_split[edge[0].low] = is_split[edge[0].high] = true;
  });
  if (health.non_manifold_edges == 0) return;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> copy_of(3 * s.faces.size(), kNone);
  std::vector<bool> original_taken(s.vertices.size(), false);
  for (std::uint32_t c = 0; c < copy_of.size(); ++c) {
    std::uint32_t& v = s.faces[c / 3].at(c % 3);
    if (!is_split[v]) continue;
    std::uint32_t& copy = copy_of[corners.find(c)];
    if (copy == kNone && !original_taken[v]) {
      original_taken[v] = true;
      copy = v;
    } else if (copy == kNone) {
      copy = static_cast<std::uint32_t>(s.vertices.size());
      const Vec3 same_place = s.vertices[v];
      s.vertices.push_back(same_place);
    }
    v = copy;
  }
}

void drop_unused(Seafloor& s, MeshHealth& health) {
  std::vector<std::uint32_t> index(s.vertices.size(), 0);
  for (const Face& f : s.faces) {
    for (const std::uint32_t v : f) index[v] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    if (index[v] == 0) continue;
    s.vertices[kept] = s.vertices[v];
    index[v] = kept++;
  }
  health.unused_vertices = s.vertices.size() - kept;
  s.vertices.resize(kept);
  for (Face& f : s.faces) {
    for (std::uint32_t& v : f) v = index[v];
  }
}

void check_plan_area(const Seafloor& s) {
  double plan = 0.0;
  double full = 0.0;
  for (const Face& f : s.faces) {
    const Vec3 normal =
        (s.vertices[f[1]] - s.vertices[f[0]]).cross(Vec3(s.vertices[f[2]] - s.vertices[f[0]]));
    plan += std::abs(normal.z());
    full += normal.norm();
  }
  if (s.faces.empty() || full == 0.0) {
    throw InvalidInput(
        "the mesh has no face with an area; every face has a corner twice or lies "
        "on a line");
  }
  if (plan <= kVerticalSheetShare * full) {
    throw InvalidInput(
        "the mesh is a vertical sheet: seen from above it has no area; check that z is its "
        "vertical axis");
  }
}

void add_notes(MeshHealth& health) {
  const auto note = [&](std::size_t n, const char* text) {
    if (n > 0) health.notes.push_back(fmt::format("{} {}", n, text));
  };
  note(health.duplicate_vertices, "vertices at the same place as another were merged");
  note(health.unused_vertices, "vertices without a face were left out");
  note(health.degenerate_faces, "faces without an area were left out");
  note(health.duplicate_faces, "faces with the corners of another were left out");
  note(health.overhanging_faces, "faces of the underside and sides of closed bodies were left out");
  note(health.flipped_faces, "faces were turned to look up");
  note(health.non_manifold_edges, "edges had more than two faces and were split apart");
}

}  // namespace

RepairedSeafloor repair(Seafloor soup) {
  check(soup);
  MeshHealth found;
  weld(soup, found);
  found.degenerate_faces += drop_needles(soup);
  found.overhanging_faces = drop_undersides(soup);
  orient_up(soup, found);
  check_plan_area(soup);
  split_non_manifold(soup, found);
  drop_unused(soup, found);
  const MeshHealth after = assess(soup);
  found.vertices = after.vertices;
  found.faces = after.faces;
  found.components = after.components;
  found.boundary_loops = after.boundary_loops;
  found.vertical_faces = after.vertical_faces;
  add_notes(found);
  return {std::move(soup), std::move(found)};
}

}  // namespace swathplan

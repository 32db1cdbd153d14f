#include "planners/nuc/nuc.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "mesh/planar/gates.h"
#include "mesh/planar/quad_mesh.h"
#include "mesh/plane/path_crossings.h"
#include "mesh/plane/segments.h"
#include "mesh/shapes.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using test::blob;
using test::box_area;

std::vector<Vec2> closed(const SkeletonCycle& cycle) {
  std::vector<Vec2> path;
  for (const SkeletonPoint& p : cycle) path.push_back(p.position);
  path.push_back(cycle.front().position);
  return path;
}

/// How often the path crosses the segment a-b, counted at its inside.
int crossings(const std::vector<Vec2>& path, const Vec2& a, const Vec2& b) {
  int count = 0;
  const auto [west, east] = std::minmax(a.x(), b.x());
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec2& p = path[i];
    const Vec2& q = path[i + 1];
    if ((p.x() < west && q.x() < west) || (p.x() > east && q.x() > east)) continue;
    const double sides = cross(b - a, p - a) * cross(b - a, q - a);
    const double ends = cross(q - p, a - p) * cross(q - p, b - p);
    if (sides < 0.0 && ends < 0.0) ++count;
  }
  return count;
}

struct MeshCase {
  std::string name;
  PlanarMesh mesh;
};

/// width x height squares, each a quad or cut into two triangles at random.
PlanarMesh mixed_lattice(int width, int height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PlanarMesh mesh;
  for (int y = 0; y <= height; ++y) {
    for (int x = 0; x <= width; ++x) {
      const double jitter = static_cast<double>(random() % 1000) / 5000.0 - 0.1;
      mesh.vertices.emplace_back(x + jitter, y - jitter);
    }
  }
  const auto node = [&](int x, int y) { return static_cast<std::uint32_t>(y * (width + 1) + x); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t a = node(x, y), b = node(x + 1, y), c = node(x + 1, y + 1),
                          d = node(x, y + 1);
      switch (random() % 3) {
        case 0:
          mesh.faces.push_back({a, b, c, d});
          break;
        case 1:
          mesh.faces.push_back({a, b, c});
          mesh.faces.push_back({a, c, d});
          break;
        default:
          mesh.faces.push_back({a, b, d});
          mesh.faces.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

std::vector<MeshCase> meshes() {
  std::vector<MeshCase> cases;
  PlanarMesh one;
  one.vertices = {{0, 0}, {10, 0}, {0, 10}};
  one.faces = {{0, 1, 2}};
  cases.push_back({"one triangle", one});
  PlanarMesh hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.vertices.emplace_back(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3));
  hexagon.faces = {{0, 1, 2, 3, 4, 5}};
  cases.push_back({"one hexagon", hexagon});
  cases.push_back({"mixed lattice", mixed_lattice(30, 20, 4)});
  cases.push_back({"mixed strip", mixed_lattice(200, 1, 9)});
  const auto add = [&](std::string name, const Area& area, double hypotenuse) {
    cases.push_back({std::move(name), planar_mesh(area, {.hypotenuse_m = hypotenuse})});
  };
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    add("blob " + std::to_string(seed), blob(0, 0, 120, seed),
        10.0 + 3.0 * static_cast<double>(seed));
  }
  add("holes", subtract(subtract(blob(0, 0, 150, 8), blob(40, 20, 25, 1)), blob(-50, -10, 22, 2)),
      14.0);
  add("ring", subtract(box_area(0, 0, 200, 200), box_area(40, 40, 160, 160)), 20.0);
  add("narrow neck",
      unite(unite(box_area(0, 0, 100, 100), box_area(99, 48, 141, 50)), box_area(140, 0, 240, 100)),
      18.0);
  add("two waters", unite(box_area(0, 0, 60, 60), box_area(70, 0, 120, 60)), 16.0);
  add("harbour", outline(harbour()), 18.0);
  add("thousands of faces", box_area(0, 0, 700, 500), 12.0);
  const auto add_quads = [&](std::string name, const Area& area, double side) {
    cases.push_back({"quads: " + std::move(name), quad_mesh(area, {.side_m = side})});
  };
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Area water = subtract(subtract(blob(0, 0, 120, seed), blob(30, 20, 20, seed + 1)),
                                box_area(-60, -30, -20, -27));
    add_quads("bay " + std::to_string(seed), water, 8.0 + 2.0 * static_cast<double>(seed));
  }
  add_quads("a single face", box_area(0, 0, 20, 18), 25.0);
  add_quads("ring", subtract(box_area(0, 0, 200, 200), box_area(40, 40, 160, 160)), 20.0);
  add_quads(
      "narrow neck",
      unite(unite(box_area(0, 0, 100, 100), box_area(99, 48, 141, 50)), box_area(140, 0, 240, 100)),
      18.0);
  add_quads("two waters", unite(box_area(0, 0, 60, 60), box_area(70, 0, 120, 60)), 16.0);
  add_quads("harbour", outline(harbour()), 18.0);
  add_quads("coarse harbour", outline(harbour()), 64.0);
  add_quads("thousands of faces", box_area(0, 0, 700, 500), 10.0);
  return cases;
}

void expect_each_sub_facet_once(const PlanarMesh& mesh, const std::vector<SkeletonCycle>& cycles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> visits;
  for (const SkeletonCycle& cycle : cycles) {
    for (const SkeletonPoint& p : cycle) {
      if (p.sub_facet) ++visits[{p.face, p.corner}];
    }
  }
  std::size_t corners = 0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    corners += mesh.faces[f].size();
    for (std::uint32_t k = 0; k < mesh.faces[f].size(); ++k) EXPECT_EQ((visits[{f, k}]), 1);
  }
  EXPECT_EQ(visits.size(), corners);
}

TEST(Nuc, VisitsEverySubFacetOnce) {
  for (const MeshCase& c : meshes()) {
    SCOPED_TRACE(c.name);
    expect_each_sub_facet_once(c.mesh, nuc_skeleton(c.mesh, shared_edges(c.mesh)));
  }
}

TEST(Nuc, NeverCrossesItself) {
  for (const MeshCase& c : meshes()) {
    SCOPED_TRACE(c.name);
    for (const SkeletonCycle& cycle : nuc_skeleton(c.mesh, shared_edges(c.mesh))) {
      EXPECT_EQ(self_crossings(closed(cycle)), 0U);
      std::vector<Vec2> path;
      for (const SkeletonPoint& p : rounded(cycle)) path.push_back(p.position);
      EXPECT_EQ(self_crossings(path), 0U) << "with rounded corners";
    }
  }
}

TEST(Nuc, OneCycleForEachPart) {
  for (const MeshCase& c : meshes()) {
    SCOPED_TRACE(c.name);
    const auto edges = shared_edges(c.mesh);
    const auto parts = connected_parts(c.mesh, edges);
    EXPECT_EQ(nuc_skeleton(c.mesh, edges).size(),
              *std::max_element(parts.begin(), parts.end()) + 1U);
  }
  EXPECT_TRUE(nuc_skeleton({}, {}).empty());
}

TEST(Nuc, TreeEdgesAreCrossedOnceInAndOnceOutOthersNever) {
  for (const MeshCase& c : meshes()) {
    if (c.mesh.faces.size() > 700) continue;
    SCOPED_TRACE(c.name);
    const auto edges = shared_edges(c.mesh);
    const auto cycles = nuc_skeleton(c.mesh, edges);
    std::size_t crossed = 0;
    for (const SharedEdge& e : edges) {
      const auto& face = c.mesh.faces[e.face[0]];
      const Vec2& a = c.mesh.vertices[face[e.edge[0]]];
      const Vec2& b = c.mesh.vertices[face[(e.edge[0] + 1) % face.size()]];
      int count = 0;
      for (const SkeletonCycle& cycle : cycles) count += crossings(closed(cycle), a, b);
      // A way led over a point of the edge touches it with two segment ends: neither is inside.
      EXPECT_TRUE(count == 0 || count == 2 || count == 1) << count;
      if (count > 0) ++crossed;
    }
    EXPECT_LE(crossed, c.mesh.faces.size() - cycles.size()) << "no more edges than a spanning tree";
  }
}

TEST(Nuc, ClosedEdgesAreNeverCrossed) {
  for (const MeshCase& c : meshes()) {
    if (c.mesh.faces.size() > 700) continue;
    SCOPED_TRACE(c.name);
    const auto edges = shared_edges(c.mesh);
    std::mt19937_64 random(edges.size());
    std::vector<char> open;
    for (std::size_t i = 0; i < edges.size(); ++i) open.push_back(random() % 3 > 0 ? 1 : 0);
    const auto cycles = nuc_skeleton(c.mesh, edges, open);
    expect_each_sub_facet_once(c.mesh, cycles);
    std::vector<std::vector<Vec2>> paths;
    for (const SkeletonCycle& cycle : cycles) {
      paths.emplace_back();
      for (const SkeletonPoint& p : rounded(cycle)) paths.back().push_back(p.position);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (open[i] != 0) continue;
      const auto& face = c.mesh.faces[edges[i].face[0]];
      const Vec2& a = c.mesh.vertices[face[edges[i].edge[0]]];
      const Vec2& b = c.mesh.vertices[face[(edges[i].edge[0] + 1) % face.size()]];
      for (const auto& path : paths) EXPECT_EQ(crossings(path, a, b), 0);
    }
  }
}

/// The MDNUC skeleton of a seafloor, with the rounded path checked against blocked edges and gates.
void expect_gates_kept(const Seafloor& floor, int bands, const PlanarMesh& mesh) {
  const DepthQuery depths(floor);
  const auto edges = shared_edges(mesh);
  const DepthRegions regions =
      depth_regions(mesh, edges, depths, {.bands = {.count = bands, .limits = {}}});
  const Gates gates = choose_gates(mesh, edges, regions, depths);
  std::vector<char> open(edges.size(), 1);
  for (const std::uint32_t i : gates.blocked_edges) open[i] = 0;
  const auto cycles = nuc_skeleton(mesh, edges, open);
  expect_each_sub_facet_once(mesh, cycles);
  ASSERT_EQ(cycles.size(), 1U);
  const SkeletonCycle& cycle = cycles[0];
  EXPECT_EQ(self_crossings(closed(cycle)), 0U);
  // The closing way is not sailed, and the cycle's ends keep their corners.
  std::vector<Vec2> path;
  for (const SkeletonPoint& p : rounded(cycle)) path.push_back(p.position);
  path.push_back(cycle.front().position);
  const auto ends = [&](std::uint32_t i) {
    const auto& face = mesh.faces[edges[i].face[0]];
    return std::pair(mesh.vertices[face[edges[i].edge[0]]],
                     mesh.vertices[face[(edges[i].edge[0] + 1) % face.size()]]);
  };
  for (const std::uint32_t i : gates.blocked_edges) {
    EXPECT_EQ(crossings(path, ends(i).first, ends(i).second), 0);
  }
  for (const Gate& gate : gates.gates) {
    EXPECT_EQ(crossings(path, ends(gate.edge).first, ends(gate.edge).second), 2)
        << "once in and once out";
  }
  // Each region is one run of the closed path for each gate into it and out of it again.
  std::size_t changes = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const auto& next = cycle[(i + 1) % cycle.size()];
    if (regions.region_of[cycle[i].face] != regions.region_of[next.face]) ++changes;
  }
  EXPECT_EQ(changes, 2 * gates.gates.size());
}

void expect_gates_kept_on_both_meshes(const Seafloor& floor, int bands, double size) {
  SCOPED_TRACE(size);
  expect_gates_kept(floor, bands, planar_mesh(outline(floor), {.hypotenuse_m = size}));
  expect_gates_kept(floor, bands, quad_mesh(outline(floor), {.side_m = size}));
}

TEST(Mdnuc, GatesAreCrossedOnceInAndOnceOutBlockedEdgesNever) {
  for (const double size : {12.0, 17.0, 25.0}) {
    expect_gates_kept_on_both_meshes(saddle(), 4, size);
    expect_gates_kept_on_both_meshes(shaft(), 2, size);
  }
  expect_gates_kept_on_both_meshes(harbour(), 4, 25.0);
}

// Regions that form a ring around an island: every neighbour pair has a border, but a gate for each
// would close the ring and enter one region twice.
TEST(Mdnuc, ARingOfRegionsIsEnteredOnce) {
  Seafloor floor = flat(120, 120, 10);
  for (Vec3& v : floor.vertices) {
    const double angle = std::atan2(v.y() - 60, v.x() - 60);
    v.z() = -10 - 10 * (1 + std::sin(2 * angle));
  }
  std::erase_if(floor.faces, [&](const Seafloor::Face& f) {
    return (floor.vertices[f[0]].head<2>() - Vec2(60, 60)).norm() < 22;
  });
  expect_gates_kept_on_both_meshes(floor, 2, 14.0);
}

TEST(Nuc, CornersAreRoundedInsideTheirFace) {
  const PlanarMesh mesh = planar_mesh(blob(0, 0, 100, 2), {.hypotenuse_m = 20});
  const auto cycles = nuc_skeleton(mesh, shared_edges(mesh));
  for (const SkeletonPoint& p : rounded(cycles[0])) {
    if (!p.sub_facet) continue;
    Ring ring;
    for (const std::uint32_t v : mesh.faces[p.face]) ring.push_back(mesh.vertices[v]);
    EXPECT_TRUE(contains({{ring, {}}}, p.position));
  }
}

}  // namespace
}  // namespace swathplan

#include "mesh/planar/depth_regions.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/base/error.h"
#include "mesh/planar/gates.h"
#include "mesh/shapes.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

struct Ground {
  Seafloor floor;
  DepthQuery depths;
  PlanarMesh mesh;
  std::vector<SharedEdge> edges;

  Ground(Seafloor seafloor, double hypotenuse)
      : floor(std::move(seafloor)),
        depths(floor),
        mesh(planar_mesh(outline(floor), {.hypotenuse_m = hypotenuse})),
        edges(shared_edges(mesh)) {}

  [[nodiscard]] DepthRegions regions(const DepthBands& bands, double smallest = 0.0) const {
    return depth_regions(mesh, edges, depths, {.bands = bands, .smallest_region_m2 = smallest});
  }
};

/// Regions are the connected sets of equal band: checked by a flood fill of its own.
void expect_connected(const Ground& ground, const DepthRegions& regions) {
  for (const DepthRegion& region : regions.regions) {
    std::set<std::uint32_t> reached{region.faces[0]};
    for (bool grown = true; grown;) {
      grown = false;
      for (const SharedEdge& e : ground.edges) {
        const bool in0 = regions.region_of[e.face[0]] == regions.region_of[region.faces[0]];
        const bool in1 = regions.region_of[e.face[1]] == regions.region_of[region.faces[0]];
        if (!in0 || !in1) continue;
        if (reached.contains(e.face[0]) != reached.contains(e.face[1])) {
          reached.insert(e.face[0]);
          reached.insert(e.face[1]);
          grown = true;
        }
      }
    }
    EXPECT_EQ(reached.size(), region.faces.size());
  }
}

TEST(DepthRegions, AStepMakesTwoRegionsWithTheirOwnMeans) {
  const Ground ground(stepped(100, 60, 10, 30), 14.0);
  const DepthRegions regions = ground.regions({.count = 2, .limits = {}});
  ASSERT_EQ(regions.regions.size(), 2U);
  EXPECT_EQ(regions.band_limits_m.size(), 1U);
  EXPECT_NEAR(regions.band_limits_m[0], 20.0, 0.5);
  EXPECT_NEAR(regions.regions[0].mean_depth_m + regions.regions[1].mean_depth_m, 40.0, 3.0);
  expect_connected(ground, regions);
}

TEST(DepthRegions, AreasAndMeansAddUp) {
  const Ground ground(saddle(), 20.0);
  const DepthRegions regions = ground.regions({.count = 4, .limits = {}});
  double area = 0.0;
  double volume = 0.0;
  std::size_t faces = 0;
  for (const DepthRegion& region : regions.regions) {
    area += region.area_m2;
    volume += region.area_m2 * region.mean_depth_m;
    faces += region.faces.size();
    EXPECT_LE(region.min_depth_m, region.mean_depth_m);
    EXPECT_GE(region.max_depth_m, region.mean_depth_m);
  }
  EXPECT_EQ(faces, ground.mesh.faces.size());
  EXPECT_NEAR(volume / area, 35.0, 0.3) << "the saddle's mean depth";
  EXPECT_GE(regions.regions.size(), 4U) << "two deep ends, two shoal ends";
  expect_connected(ground, regions);
}

TEST(DepthRegions, SliversJoinTheNeighbourWithTheLongestBorder) {
  const Ground ground(saddle(), 20.0);
  const DepthRegions fine = ground.regions({.count = 8, .limits = {}}, 0.0);
  const DepthRegions merged = ground.regions({.count = 8, .limits = {}}, 300.0);
  EXPECT_LT(merged.regions.size(), fine.regions.size());
  for (const DepthRegion& region : merged.regions) EXPECT_GE(region.area_m2, 300.0);
  expect_connected(ground, merged);
}

TEST(DepthRegions, ABandWithoutFacesIsNamed) {
  const Ground ground(flat(60, 60, 10), 20.0);
  try {
    static_cast<void>(ground.regions({.count = 1, .limits = {5.0, 20.0}}));
    FAIL() << "accepted";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("depth bands"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("10.00"), std::string::npos) << e.what();
  }
}

/// Gates: a spanning tree of regions; every other border edge blocked.
void expect_tree(const Ground& ground, const DepthRegions& regions, const Gates& gates) {
  std::size_t border = 0;
  for (const SharedEdge& e : ground.edges) {
    if (regions.region_of[e.face[0]] != regions.region_of[e.face[1]]) ++border;
  }
  EXPECT_EQ(gates.gates.size() + gates.blocked_edges.size(), border);
  EXPECT_EQ(gates.gates.size(), regions.regions.size() - 1) << "one water, so a tree spans it";
  std::vector<std::uint32_t> root(regions.regions.size());
  for (std::uint32_t r = 0; r < root.size(); ++r) root[r] = r;
  for (const Gate& gate : gates.gates) {
    const std::uint32_t from = root[gate.region_a];
    const std::uint32_t to = root[gate.region_b];
    EXPECT_NE(from, to) << "a ring of gates";
    for (std::uint32_t& r : root) r = r == from ? to : r;
  }
}

TEST(Gates, SpanTheRegionsAsATree) {
  for (const double hypotenuse : {10.0, 17.0, 25.0}) {
    const Ground ground(saddle(), hypotenuse);
    const DepthRegions regions = ground.regions({.count = 4, .limits = {}});
    expect_tree(ground, regions, choose_gates(ground.mesh, ground.edges, regions, ground.depths));
  }
  const Ground ground(harbour(), 25.6);
  const DepthRegions regions = ground.regions({.count = 5, .limits = {}});
  expect_tree(ground, regions, choose_gates(ground.mesh, ground.edges, regions, ground.depths));
}

TEST(Gates, TheFlattestEdgeIsChosen) {
  // A wall at mid-width that turns into a gentle ramp in the north: the gate must lie there.
  Seafloor floor = flat(100, 100, 10);
  for (Vec3& v : floor.vertices) {
    const double width = v.y() > 75 ? 30.0 : 2.0;
    const double t = std::clamp((v.x() - 50) / width + 0.5, 0.0, 1.0);
    v.z() = -10 - 20 * t;
  }
  const Ground ground(floor, 20.0);
  const DepthRegions regions = ground.regions({.count = 2, .limits = {}}, 300.0);
  ASSERT_EQ(regions.regions.size(), 2U);
  const Gates gates = choose_gates(ground.mesh, ground.edges, regions, ground.depths);
  ASSERT_EQ(gates.gates.size(), 1U);
  const SharedEdge& e = ground.edges[gates.gates[0].edge];
  const Vec2 middle =
      0.5 * (face_centroid(ground.mesh, e.face[0]) + face_centroid(ground.mesh, e.face[1]));
  EXPECT_GT(middle.y(), 70.0);
}

}  // namespace
}  // namespace swathplan

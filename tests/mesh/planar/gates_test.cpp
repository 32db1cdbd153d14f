#include "mesh/planar/gates.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"

namespace swathplan {
namespace {

/// Faces and the region of each; depths do not come into it.
struct Layout {
  PlanarMesh mesh;
  DepthRegions regions;
};

Gates gates_of(const Layout& layout, const Seafloor& floor) {
  const DepthQuery depths(floor);
  return choose_gates(layout.mesh, shared_edges(layout.mesh), layout.regions, depths);
}

DepthRegions regions_of(std::vector<std::uint32_t> region_of) {
  DepthRegions regions;
  for (std::uint32_t f = 0; f < region_of.size(); ++f) {
    if (region_of[f] >= regions.regions.size()) regions.regions.resize(region_of[f] + 1);
    regions.regions[region_of[f]].faces.push_back(f);
  }
  regions.region_of = std::move(region_of);
  return regions;
}

/// Four squares of 10 m, each a region of its own, which form a ring.
Layout ring_of_squares() {
  Layout layout;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) layout.mesh.vertices.emplace_back(10.0 * x, 10.0 * y);
  }
  layout.mesh.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
  layout.regions = regions_of({0, 1, 2, 3});
  return layout;
}

TEST(ChosenGates, ARingIsOpenedAtItsSteepestSide) {
  // A wall in the plane between the two squares of the north, halfway along their edge.
  Seafloor floor = flat(20, 20, 10);
  for (Vec3& v : floor.vertices) {
    if (v.x() > 10.0 && v.y() > 10.0) v.z() = v.y() > 11.5 ? -25.0 : -10.0;
  }
  const Layout layout = ring_of_squares();
  const Gates gates = gates_of(layout, floor);
  ASSERT_EQ(gates.gates.size(), 3U);
  ASSERT_EQ(gates.blocked_edges.size(), 1U);
  const SharedEdge closed = shared_edges(layout.mesh)[gates.blocked_edges[0]];
  EXPECT_EQ(closed.face[1], 3U) << "a side of the deep square";
  EXPECT_EQ(gates.gates[0].slope.deg(), 0.0);
}

TEST(ChosenGates, OnLevelGroundTheLongestEdgeIsTheGate) {
  // One tall face beside a short and a long one of the same region.
  Layout layout;
  layout.mesh.vertices = {{0, 0},   {10, 0}, {20, 0},  {10, 10},
                          {20, 10}, {0, 30}, {10, 30}, {20, 30}};
  layout.mesh.faces = {{0, 1, 3, 6, 5}, {1, 2, 4, 3}, {3, 4, 7, 6}};
  layout.regions = regions_of({0, 1, 1});
  const Gates gates = gates_of(layout, flat(20, 30, 12));
  ASSERT_EQ(gates.gates.size(), 1U);
  EXPECT_EQ(gates.gates[0].region_a, 0U);
  EXPECT_EQ(gates.gates[0].region_b, 1U);
  const SharedEdge gate = shared_edges(layout.mesh)[gates.gates[0].edge];
  EXPECT_EQ(gate.face[1], 2U);
  EXPECT_EQ(gates.blocked_edges.size(), 1U);
}

TEST(ChosenGates, TheSlopeIsThatOfTheSeafloorAcrossTheEdge) {
  Layout layout = ring_of_squares();
  layout.mesh.faces.resize(2);
  layout.regions = regions_of({0, 1});
  const Gates gates = gates_of(layout, tilted(20, 20, 10, Angle::degrees(20)));
  ASSERT_EQ(gates.gates.size(), 1U);
  EXPECT_NEAR(gates.gates[0].slope.deg(), 20.0, 0.05);
}

TEST(ChosenGates, OneRegionNeedsNone) {
  Layout layout = ring_of_squares();
  layout.regions = regions_of({0, 0, 0, 0});
  const Gates gates = gates_of(layout, flat(20, 20, 10));
  EXPECT_TRUE(gates.gates.empty());
  EXPECT_TRUE(gates.blocked_edges.empty());
}

}  // namespace
}  // namespace swathplan

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/edge_table.h"
#include "mesh/repair/needles_internal.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

/// Edges that one face alone uses.
std::size_t open_edges(const Seafloor& mesh) {
  std::size_t open = 0;
  for_each_edge(edge_uses(mesh.faces, mesh.vertices.size()),
                [&](std::span<const EdgeUse> edge) { open += edge.size() == 1 ? 1 : 0; });
  return open;
}

/// Two triangles about the edge 0-1 with a needle between them, its middle corner at vertex 4.
Seafloor with_needle() {
  Seafloor mesh;
  mesh.vertices = {{0, 0, -5}, {4, 0, -5}, {2, 3, -5}, {2, -3, -5}, {1, 0, -5}};
  // Below, the edge already runs over the corner; above it does not: the needle fills the crack.
  mesh.faces = {{0, 1, 2}, {1, 0, 4}, {0, 3, 4}, {4, 3, 1}};
  return mesh;
}

TEST(Needles, TheNeighbourIsCutAtTheMiddleCorner) {
  Seafloor mesh = with_needle();
  const auto vertices = mesh.vertices;
  const double area = plan_area_m2(mesh);
  const std::size_t open = open_edges(mesh);
  EXPECT_EQ(drop_needles(mesh), 1U);
  EXPECT_EQ(mesh.faces.size(), 4U);
  EXPECT_EQ(open_edges(mesh), open);
  EXPECT_EQ(open, 4U);
  EXPECT_NEAR(plan_area_m2(mesh), area, 1e-12);
  EXPECT_TRUE(mesh.vertices == vertices);
  const auto uses_middle = [](const Seafloor::Face& f) {
    return std::find(f.begin(), f.end(), 4U) != f.end();
  };
  EXPECT_EQ(std::count_if(mesh.faces.begin(), mesh.faces.end(), uses_middle), 4);
}

TEST(Needles, ANeedleOnTheBorderGoesAlone) {
  Seafloor mesh = with_needle();
  mesh.faces = {{1, 0, 4}, {0, 3, 4}, {4, 3, 1}};
  EXPECT_EQ(drop_needles(mesh), 1U);
  EXPECT_EQ(mesh.faces, (std::vector<Seafloor::Face>{{0, 3, 4}, {4, 3, 1}}));
}

TEST(Needles, TwoNeedlesBackToBackBothGo) {
  Seafloor mesh = with_needle();
  mesh.faces = {{1, 0, 4}, {0, 1, 4}};
  EXPECT_EQ(drop_needles(mesh), 2U);
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(Needles, ThinFacesWithAreaStay) {
  Seafloor mesh;
  mesh.vertices = {{0, 0, -5}, {1e6, 0, -5}, {5e5, 1e-6, -5}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_EQ(drop_needles(mesh), 0U);
  EXPECT_EQ(mesh.faces.size(), 1U);
  Seafloor rough = saddle();
  const auto faces = rough.faces;
  EXPECT_EQ(drop_needles(rough), 0U);
  EXPECT_EQ(rough.faces, faces);
}

}  // namespace
}  // namespace swathplan

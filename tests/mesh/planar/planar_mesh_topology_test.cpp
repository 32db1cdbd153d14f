#include <gtest/gtest.h>

#include <array>

#include "mesh/base/error.h"
#include "mesh/planar/planar_mesh.h"

namespace swathplan {
namespace {

TEST(SharedEdges, EachInnerEdgeOnce) {
  // Two triangles and a quad in a row: two inner edges.
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5, 2}};
  const auto edges = shared_edges(mesh);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].face, (std::array<std::uint32_t, 2>{0, 2}));
  EXPECT_EQ(edges[1].face, (std::array<std::uint32_t, 2>{0, 1}));
}

TEST(SharedEdges, AnEdgeOfThreeFacesIsRefused) {
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {0, 1}, {0, 2}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_THROW(static_cast<void>(shared_edges(mesh)), InvalidInput);
}

TEST(SharedEdges, AnEdgeRunTwiceInTheSameSenseIsRefused) {
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {0, 1}, {0, -1}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_THROW(static_cast<void>(shared_edges(mesh)), InvalidInput);
}

TEST(ConnectedParts, FacesThatMeetAtACornerOnlyAreTwoParts) {
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  mesh.faces = {{0, 1, 2}, {2, 4, 5, 6}, {0, 2, 3}};
  EXPECT_EQ(connected_parts(mesh, shared_edges(mesh)), (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST(PlanarFaces, HaveThePolygonsAreaAndTheCornersMean) {
  // An L of three unit squares.
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  mesh.faces = {{0, 1, 2, 3, 4, 5}, {0, 1, 2}};
  EXPECT_DOUBLE_EQ(face_area(mesh, 0), 3.0);
  EXPECT_DOUBLE_EQ(face_area(mesh, 1), 1.0);
  EXPECT_NEAR((face_centroid(mesh, 1) - Vec2(4.0 / 3.0, 1.0 / 3.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((face_centroid(mesh, 0) - Vec2(1.0, 1.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace swathplan

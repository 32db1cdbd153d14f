#include "mesh/planar/face_merging.h"

#include <gtest/gtest.h>

#include "mesh/plane/polygons.h"

namespace swathplan {
namespace {

/// A row of `count` squares of 10 m.
PlanarMesh row_of_squares(std::uint32_t count) {
  PlanarMesh mesh;
  for (std::uint32_t i = 0; i <= count; ++i) {
    mesh.vertices.emplace_back(10.0 * i, 0.0);
    mesh.vertices.emplace_back(10.0 * i, 10.0);
  }
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return mesh;
}

double whole_area(const PlanarMesh& mesh) {
  double sum = 0.0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) sum += face_area(mesh, f);
  return sum;
}

TEST(FaceMerging, ADiagonalIsTakenAwayFromASquare) {
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  FaceMerging merging(mesh);
  merging.take_away({{0, 2}});
  const PlanarMesh result = merging.result();
  ASSERT_EQ(result.faces.size(), 1U);
  EXPECT_EQ(result.faces[0].size(), 4U);
  EXPECT_DOUBLE_EQ(whole_area(result), 100.0);
}

TEST(FaceMerging, AnEdgeStaysWhereTheJointFaceWouldBeHollow) {
  // Two arms of an L: joined they have a reflex corner that an arc would cut.
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {30, 0}, {30, 10}, {10, 10}, {0, 10}, {10, 40}, {0, 40}};
  mesh.faces = {{0, 1, 2, 3, 4}, {4, 3, 5, 6}};
  FaceMerging merging(mesh);
  merging.take_away({{3, 4}, {0, 6}});  // the second is no edge at all
  const PlanarMesh result = merging.result();
  EXPECT_EQ(result.faces.size(), 2U);
  EXPECT_DOUBLE_EQ(whole_area(result), whole_area(mesh));
}

TEST(FaceMerging, CornersOnStraightSidesGo) {
  FaceMerging merging(row_of_squares(3));
  merging.take_away({{2, 3}, {4, 5}});
  const PlanarMesh result = merging.result();
  ASSERT_EQ(result.faces.size(), 1U);
  EXPECT_EQ(result.faces[0].size(), 4U);
  EXPECT_EQ(result.vertices.size(), 4U);
  EXPECT_DOUBLE_EQ(whole_area(result), 300.0);
}

TEST(FaceMerging, SmallFacesJoinWithinTheLimits) {
  const PlanarMesh mesh = row_of_squares(4);
  const auto joined = [&](const MergeLimits& limits) {
    FaceMerging merging(mesh);
    merging.join_small(limits);
    const PlanarMesh result = merging.result();
    EXPECT_DOUBLE_EQ(whole_area(result), 400.0);
    return result;
  };
  const auto pairs = joined({.small_m2 = 150.0, .largest_m2 = 250.0, .longest_m = 100.0});
  EXPECT_EQ(pairs.faces.size(), 2U);
  for (std::uint32_t f = 0; f < pairs.faces.size(); ++f) EXPECT_LE(face_area(pairs, f), 250.0);
  EXPECT_EQ(joined({.small_m2 = 150.0, .largest_m2 = 250.0, .longest_m = 15.0}).faces.size(), 4U);
  EXPECT_EQ(joined({.small_m2 = 50.0, .largest_m2 = 250.0, .longest_m = 100.0}).faces.size(), 4U);
}

TEST(FaceMerging, WithoutAWishTheMeshStays) {
  const PlanarMesh mesh = row_of_squares(2);
  const PlanarMesh result = FaceMerging(mesh).result();
  EXPECT_EQ(result.faces.size(), 2U);
  EXPECT_EQ(result.vertices.size(), 6U);
}

}  // namespace
}  // namespace swathplan

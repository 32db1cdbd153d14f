#include "mesh/repair/mesh_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using Face = Seafloor::Face;

double signed_plan_area(const Seafloor& s, const Face& f) {
  const Vec2 ab = (s.vertices[f[1]] - s.vertices[f[0]]).head<2>();
  const Vec2 ac = (s.vertices[f[2]] - s.vertices[f[0]]).head<2>();
  return 0.5 * (ab.x() * ac.y() - ab.y() * ac.x());
}

double plan_area(const Seafloor& s) {
  double sum = 0.0;
  for (const Face& f : s.faces) sum += signed_plan_area(s, f);
  return sum;
}

std::string refusal(const Seafloor& s) {
  try {
    (void)repair(s);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Every face with its own three vertices, in another order, some of them turned over.
Seafloor shredded(const Seafloor& whole) {
  Seafloor soup;
  std::mt19937 random(3);
  std::vector<Face> faces = whole.faces;
  std::shuffle(faces.begin(), faces.end(), random);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Face& f = faces[i];
    if (i % 3 == 0) std::swap(f[1], f[2]);
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t v : f) soup.vertices.push_back(whole.vertices[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// A block [0, 4]^2 x [-9, top] whose top steps from -5 (x < 2) to -3: closed, facing outwards.
Seafloor stepped_block() {
  const std::vector<Vec2> profile = {{0, -9}, {4, -9}, {4, -3}, {2, -3}, {2, -5}, {0, -5}};
  const std::vector<Face> caps = {{0, 1, 4}, {0, 4, 5}, {1, 2, 4}, {2, 3, 4}};
  Seafloor s;
  for (const double y : {0.0, 4.0}) {
    for (const Vec2& p : profile) s.vertices.emplace_back(p.x(), y, p.y());
  }
  for (const Face& f : caps) {
    s.faces.push_back(f);
    s.faces.push_back({f[0] + 6, f[2] + 6, f[1] + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    s.faces.push_back({i, i + 6, j});
    s.faces.push_back({j, i + 6, j + 6});
  }
  return s;
}

TEST(MeshRepair, CleanMeshStaysAsItIs) {
  const Seafloor s = saddle();
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.seafloor.vertices.size(), s.vertices.size());
  EXPECT_EQ(r.seafloor.faces.size(), s.faces.size());
  EXPECT_TRUE(r.health.notes.empty()) << r.health.notes.front();
  EXPECT_EQ(r.health.components, 1U);
  EXPECT_EQ(r.health.boundary_loops, 1U);
}

TEST(MeshRepair, ShreddedMeshIsWeldedAndTurnedUp) {
  const Seafloor s = saddle();
  const RepairedSeafloor r = repair(shredded(s));
  EXPECT_EQ(r.seafloor.vertices.size(), s.vertices.size());
  EXPECT_EQ(r.seafloor.faces.size(), s.faces.size());
  EXPECT_EQ(r.health.duplicate_vertices, 3 * s.faces.size() - s.vertices.size());
  EXPECT_EQ(r.health.flipped_faces, (s.faces.size() + 2) / 3);
  EXPECT_EQ(r.health.components, 1U);
  EXPECT_EQ(r.health.boundary_loops, 1U);
  for (const Face& f : r.seafloor.faces) EXPECT_GT(signed_plan_area(r.seafloor, f), 0.0);
}

TEST(MeshRepair, VerticesAreNotMoved) {
  Seafloor s = saddle();
  for (Vec3& v : s.vertices) v += Vec3(585000.123, 4797000.456, -0.1);
  const RepairedSeafloor r = repair(shredded(s));
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::vector<Vec3> before = s.vertices;
  std::vector<Vec3> after = r.seafloor.vertices;
  std::sort(before.begin(), before.end(), less);
  std::sort(after.begin(), after.end(), less);
  EXPECT_EQ(before, after);
}

TEST(MeshRepair, DegenerateDuplicateAndUnusedPartsGo) {
  Seafloor s;
  s.vertices = {Vec3(0, 0, -1), Vec3(4, 0, -1), Vec3(0, 4, -2), Vec3(9, 9, -9)};
  s.faces = {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {0, 0, 1}};
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.seafloor.faces.size(), 1U);
  EXPECT_EQ(r.seafloor.vertices.size(), 3U);
  EXPECT_EQ(r.health.duplicate_faces, 2U);
  EXPECT_EQ(r.health.degenerate_faces, 1U);
  EXPECT_EQ(r.health.unused_vertices, 1U);
}

TEST(MeshRepair, NeedleIsTakenOutWithoutOpeningACrack) {
  // The needle 0-4-1 fills a T-junction between the face above it and the two faces below.
  Seafloor s;
  s.vertices = {Vec3(0, 0, -1), Vec3(4, 0, -3), Vec3(2, 3, -5), Vec3(2, -3, -5), Vec3(2, 0, -2)};
  s.faces = {{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {4, 3, 1}};
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.health.degenerate_faces, 1U);
  EXPECT_EQ(r.seafloor.faces.size(), 4U);
  EXPECT_EQ(r.health.boundary_loops, 1U);
  EXPECT_DOUBLE_EQ(plan_area(r.seafloor), 12.0);
}

TEST(MeshRepair, RowOfNeedlesIsTakenOut) {
  // A fan of needles along one edge, each beside the next.
  Seafloor s;
  s.vertices = {Vec3(0, 0, -1), Vec3(8, 0, -1), Vec3(4, 4, -1), Vec3(2, 0, -1),
                Vec3(4, 0, -1), Vec3(6, 0, -1), Vec3(4, -4, -1)};
  s.faces = {{0, 1, 2}, {0, 3, 1}, {3, 4, 1}, {4, 5, 1},
             {3, 0, 6}, {4, 3, 6}, {5, 4, 6}, {1, 5, 6}};
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.health.degenerate_faces, 3U);
  EXPECT_EQ(r.health.boundary_loops, 1U);
  EXPECT_DOUBLE_EQ(plan_area(r.seafloor), 32.0);
}

TEST(MeshRepair, EdgeOfThreeFacesIsSplitApart) {
  Seafloor s;
  s.vertices = {Vec3(0, 0, -5), Vec3(0, 4, -5), Vec3(4, 2, -5), Vec3(-4, 2, -5), Vec3(3, 2, -1)};
  s.faces = {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}};
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.health.non_manifold_edges, 1U);
  EXPECT_EQ(assess(r.seafloor).non_manifold_edges, 0U);
  EXPECT_EQ(r.seafloor.faces.size(), 3U);
  for (const Face& f : r.seafloor.faces) EXPECT_GT(signed_plan_area(r.seafloor, f), 0.0);
}

TEST(MeshRepair, ClosedBodyKeepsItsUpperSideAndInnerWall) {
  for (const bool inside_out : {false, true}) {
    Seafloor s = stepped_block();
    if (inside_out) {
      for (Face& f : s.faces) std::swap(f[1], f[2]);
    }
    const RepairedSeafloor r = repair(s);
    EXPECT_EQ(r.seafloor.faces.size(), 6U);  // two upper squares and the step between them
    EXPECT_EQ(r.health.vertical_faces, 2U);
    EXPECT_EQ(r.health.overhanging_faces, s.faces.size() - 6);
    EXPECT_DOUBLE_EQ(plan_area(r.seafloor), 16.0);
    for (const Vec3& v : r.seafloor.vertices) EXPECT_GE(v.z(), -5.0);
  }
}

TEST(MeshRepair, ClosedBodyOfMixedSensesIsSortedOutFirst) {
  Seafloor s = stepped_block();
  for (std::size_t f = 0; f < s.faces.size(); f += 2) std::swap(s.faces[f][1], s.faces[f][2]);
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.seafloor.faces.size(), 6U);
  EXPECT_DOUBLE_EQ(plan_area(r.seafloor), 16.0);
}

TEST(MeshRepair, WallsTakeTheSenseOfTheirNeighbours) {
  // A step: low square, wall, high square. The wall must run its edges against both.
  Seafloor s;
  s.vertices = {Vec3(0, 0, -5), Vec3(2, 0, -5), Vec3(2, 2, -5), Vec3(0, 2, -5),
                Vec3(2, 0, -3), Vec3(2, 2, -3), Vec3(4, 0, -3), Vec3(4, 2, -3)};
  s.faces = {{0, 1, 2}, {0, 2, 3}, {1, 2, 4}, {4, 5, 2}, {4, 6, 7}, {4, 7, 5}};
  const RepairedSeafloor r = repair(s);
  EXPECT_EQ(r.health.vertical_faces, 2U);
  for (std::size_t a = 0; a < r.seafloor.faces.size(); ++a) {
    for (std::size_t b = a + 1; b < r.seafloor.faces.size(); ++b) {
      for (std::size_t i = 0; i < 9; ++i) {
        const Face& f = r.seafloor.faces[a];
        const Face& g = r.seafloor.faces[b];
        const bool same_way =
            f.at(i / 3) == g.at(i % 3) && f.at((i / 3 + 1) % 3) == g.at((i % 3 + 1) % 3);
        EXPECT_FALSE(same_way) << "faces " << a << " and " << b;
      }
    }
  }
}

TEST(MeshRepair, RefusesWhatIsNoSeafloor) {
  Seafloor s;
  EXPECT_THAT(refusal(s), testing::HasSubstr("no faces"));
  s.vertices = {Vec3(0, 0, -1), Vec3(1, 0.1, -1), Vec3(3, 0.3, -5)};
  s.faces = {{0, 1, 2}};
  EXPECT_THAT(refusal(s), testing::HasSubstr("vertical sheet"));
  s.faces = {{0, 1, 7}};
  EXPECT_THAT(refusal(s), testing::HasSubstr("face 1 asks for vertex 8"));
  s.faces = {{0, 1, 1}};
  EXPECT_THAT(refusal(s), testing::HasSubstr("no face with an area"));
  s.faces = {{0, 1, 2}};
  s.vertices[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(s), testing::HasSubstr("vertex 2"));
  s.vertices[1].y() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(s), testing::HasSubstr("vertex 2"));
}

}  // namespace
}  // namespace swathplan

#include "mesh/planar/quad_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/base/error.h"
#include "mesh/planar/face_layout.h"
#include "mesh/planar/face_merging.h"
#include "mesh/shapes.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using test::blob;
using test::box_area;

struct QuadCase {
  std::string name;
  Area area;
  double side;
};

/// An island somewhere in a bay, moles from its shore, all seeded.
Area bay(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  Area area = blob(0, 0, 150, seed);
  area = subtract(area, blob(between(-50, 50), between(-50, 50), between(8, 30), seed + 1));
  for (int mole = 0; mole < 3; ++mole) {
    const double x = between(-120, 80);
    const double y = between(-120, 80);
    area = subtract(area, box_area(x, y, x + between(2, 90), y + between(2, 20)));
  }
  return area;
}

std::vector<QuadCase> quad_cases() {
  std::vector<QuadCase> result{
      {"square", box_area(0, 0, 80, 80), 25.6},
      {"a single face", box_area(0, 0, 20, 19), 25.6},
      {"smaller than a face", box_area(0, 0, 5, 4), 25.6},
      {"corners on the lattice", subtract(box_area(0, 0, 100, 100), box_area(50, 50, 101, 101)),
       25},
      {"ring", subtract(box_area(0, 0, 200, 200), box_area(60, 60, 140, 140)), 25.6},
      {"a hole inside a cell", subtract(box_area(0, 0, 100, 100), box_area(30, 30, 34, 33)), 50},
      {"two holes",
       subtract(subtract(blob(0, 0, 150, 8), blob(40, 20, 18, 1)), blob(-50, -10, 12, 2)), 25.6},
      {"narrow neck",
       unite(unite(box_area(0, 0, 100, 100), box_area(99, 48, 141, 50)),
             box_area(140, 0, 240, 100)),
       18},
      {"two waters", unite(box_area(0, 0, 60, 60), box_area(60.5, 0, 120, 60)), 16},
      {"harbour", outline(harbour()), 25.6},
      {"coarse harbour", outline(harbour()), 64},
      {"far from the origin", box_area(480000, 6105000, 480200, 6105100), 25.6},
      {"thousands of faces", box_area(0, 0, 900, 700), 12},
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    result.push_back({"bay " + std::to_string(seed), bay(seed), 10.0 + static_cast<double>(seed)});
  }
  return result;
}

double area_of_quads(const PlanarMesh& mesh) {
  double sum = 0.0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) sum += face_area(mesh, f);
  return sum;
}

TEST(QuadMesh, CoversTheWholeArea) {
  for (const QuadCase& c : quad_cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = quad_mesh(c.area, {.side_m = c.side});
    const double whole = area_m2(face_layout(c.area, c.side, {}).area);
    EXPECT_NEAR(area_of_quads(mesh), whole, 1e-6 * whole);
    EXPECT_LE(whole, area_m2(c.area) * (1 + 1e-6));
  }
}

// What is inside lies between two faces: else a corner of one would hang on a neighbour's side.
TEST(QuadMesh, FacesMeetEdgeToEdge) {
  for (const QuadCase& c : quad_cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = quad_mesh(c.area, {.side_m = c.side});
    double outline_m = 0.0;
    for (const Polygon& polygon : face_layout(c.area, c.side, {}).area) {
      const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          outline_m += (ring[(i + 1) % ring.size()] - ring[i]).norm();
        }
      };
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
    double sides_m = 0.0;
    for (const auto& face : mesh.faces) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        sides_m += (mesh.vertices[face[k]] - mesh.vertices[face[(k + 1) % face.size()]]).norm();
      }
    }
    double shared_m = 0.0;
    for (const SharedEdge& e : shared_edges(mesh)) {
      const auto& face = mesh.faces[e.face[0]];
      shared_m +=
          (mesh.vertices[face[e.edge[0]]] - mesh.vertices[face[(e.edge[0] + 1) % face.size()]])
              .norm();
    }
    EXPECT_NEAR(sides_m - 2.0 * shared_m, outline_m, 1e-6 * outline_m);
  }
}

TEST(QuadMesh, EveryFaceIsSoundForNuc) {
  for (const QuadCase& c : quad_cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = quad_mesh(c.area, {.side_m = c.side});
    for (const auto& face : mesh.faces) EXPECT_TRUE(sound_for_nuc(mesh, face));
  }
}

TEST(QuadMesh, OnePartForEachPolygon) {
  for (const QuadCase& c : quad_cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = quad_mesh(c.area, {.side_m = c.side});
    const auto parts = connected_parts(mesh, shared_edges(mesh));
    EXPECT_EQ(*std::max_element(parts.begin(), parts.end()) + 1U,
              face_layout(c.area, c.side, {}).area.size());
  }
}

TEST(QuadMesh, ARectangleIsAllQuads) {
  const PlanarMesh mesh = quad_mesh(box_area(0, 0, 400, 300), {.side_m = 20.0});
  EXPECT_EQ(mesh.faces.size(), 20U * 15U);
  for (const auto& face : mesh.faces) EXPECT_EQ(face.size(), 4U);
}

TEST(QuadMesh, PiecesOfCellsAreRarelyLeftAlone) {
  for (const QuadCase& c : quad_cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = quad_mesh(c.area, {.side_m = c.side});
    EXPECT_LT(static_cast<double>(mesh.faces.size()),
              1.5 * area_m2(c.area) / (c.side * c.side) + 4.0);
  }
}

TEST(QuadMesh, TheSameAreaGivesTheSameMesh) {
  const Area area = outline(harbour());
  const PlanarMesh a = quad_mesh(area, {.side_m = 30});
  const PlanarMesh b = quad_mesh(area, {.side_m = 30});
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_TRUE(a.vertices == b.vertices);
}

TEST(QuadMesh, BadInputIsRefused) {
  EXPECT_THROW(static_cast<void>(quad_mesh({}, {.side_m = 10})), InvalidInput);
  EXPECT_THROW(static_cast<void>(quad_mesh(box_area(0, 0, 1, 1), {.side_m = 0})), UsageError);
}

TEST(SoundForNuc, ConvexFacesAreHollowOnesAreNot) {
  PlanarMesh mesh;
  mesh.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 0}, {5, 5}, {5, 0.2}};
  EXPECT_TRUE(sound_for_nuc(mesh, {0, 1, 2, 3}));
  EXPECT_TRUE(sound_for_nuc(mesh, {0, 4, 1, 2, 3})) << "a corner on a straight side";
  EXPECT_TRUE(sound_for_nuc(mesh, {0, 6, 1, 2, 3})) << "hardly hollow";
  EXPECT_FALSE(sound_for_nuc(mesh, {0, 5, 1, 2, 3})) << "an arc would cut the corner";
  EXPECT_FALSE(sound_for_nuc(mesh, {0, 3, 2, 1})) << "clockwise";
  EXPECT_FALSE(sound_for_nuc(mesh, {0, 1}));
}

}  // namespace
}  // namespace swathplan

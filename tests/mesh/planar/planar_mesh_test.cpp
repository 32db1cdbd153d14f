#include "mesh/planar/planar_mesh.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/base/error.h"
#include "mesh/plane/area_query.h"
#include "mesh/shapes.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using test::blob;
using test::box_area;

double total_area(const PlanarMesh& mesh) {
  double sum = 0.0;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) sum += face_area(mesh, f);
  return sum;
}

bool counter_clockwise(const PlanarMesh& mesh) {
  for (const auto& face : mesh.faces) {
    Ring ring;
    for (const std::uint32_t v : face) ring.push_back(mesh.vertices[v]);
    if (!(signed_area(ring) > 0.0)) return false;
  }
  return true;
}

struct Case {
  const char* name;
  Area area;
  double hypotenuse;
};

std::vector<Case> cases() {
  const Area neck = unite(unite(box_area(0, 0, 100, 100), box_area(100, 48, 140, 52)),
                          box_area(140, 0, 240, 100));
  return {
      {"square", box_area(0, 0, 80, 80), 25.6},
      {"turned blob", blob(0, 0, 90, 5), 25.6},
      {"ring", subtract(box_area(0, 0, 200, 200), box_area(60, 60, 140, 140)), 25.6},
      {"two holes",
       subtract(subtract(blob(0, 0, 150, 8), blob(40, 20, 18, 1)), blob(-50, -10, 12, 2)), 25.6},
      {"narrow neck", neck, 25.6},
      {"harbour", outline(harbour()), 25.6},
      {"coarse harbour", outline(harbour()), 64.0},
      {"smaller than a face", box_area(0, 0, 5, 4), 25.6},
      {"far from the origin", box_area(480000, 6105000, 480200, 6105100), 25.6},
  };
}

TEST(PlanarMesh, CoversTheAreaAndNeverLeavesIt) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = planar_mesh(c.area, {.hypotenuse_m = c.hypotenuse});
    ASSERT_FALSE(mesh.faces.empty());
    EXPECT_TRUE(counter_clockwise(mesh));
    const double whole = area_m2(c.area);
    EXPECT_LE(total_area(mesh), whole * (1 + 1e-6));
    // Guarantee 1: only a seam of the outline's tolerance is lost.
    double outline_length = 0.0;
    for (const Polygon& polygon : c.area) {
      const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          outline_length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
        }
      };
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
    EXPECT_GE(total_area(mesh), whole - 0.05 * c.hypotenuse * outline_length);
    const AreaQuery query(c.area);
    for (const SharedEdge& e : shared_edges(mesh)) {
      const auto& face = mesh.faces[e.face[0]];
      const Vec2& a = mesh.vertices[face[e.edge[0]]];
      const Vec2& b = mesh.vertices[face[(e.edge[0] + 1) % face.size()]];
      EXPECT_NEAR(query.inside_length(a, b), (b - a).norm(), 1e-3);
    }
  }
}

TEST(PlanarMesh, StaysInOnePieceThroughANarrowNeck) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const PlanarMesh mesh = planar_mesh(c.area, {.hypotenuse_m = c.hypotenuse});
    const auto parts = connected_parts(mesh, shared_edges(mesh));
    EXPECT_EQ(*std::max_element(parts.begin(), parts.end()), c.area.size() - 1);
  }
}

TEST(PlanarMesh, SeparateAreasStaySeparate) {
  const Area two = unite(box_area(0, 0, 60, 60), box_area(60.5, 0, 120, 60));
  const PlanarMesh mesh = planar_mesh(two, {.hypotenuse_m = 25.6});
  const auto parts = connected_parts(mesh, shared_edges(mesh));
  EXPECT_EQ(*std::max_element(parts.begin(), parts.end()), 1U);
}

TEST(PlanarMesh, FacesInTheOpenAreRightIsosceles) {
  const double hypotenuse = 20.0;
  const PlanarMesh mesh = planar_mesh(box_area(0, 0, 400, 300), {.hypotenuse_m = hypotenuse});
  std::size_t good = 0;
  for (const auto& face : mesh.faces) {
    std::array<double, 3> side{};
    for (std::size_t k = 0; k < 3; ++k) {
      side[k] = (mesh.vertices[face[k]] - mesh.vertices[face[(k + 1) % 3]]).norm();
    }
    std::sort(side.begin(), side.end());
    const bool right = std::abs(side[0] * side[0] + side[1] * side[1] - side[2] * side[2]) <
                       0.05 * side[2] * side[2];
    if (right && side[0] > 0.85 * side[1] && std::abs(side[2] - hypotenuse) < 0.1 * hypotenuse)
      ++good;
  }
  EXPECT_GE(static_cast<double>(good), 0.95 * static_cast<double>(mesh.faces.size()));
}

TEST(PlanarMesh, TurningTheAreaTurnsTheMesh) {
  const double angle = 0.37;
  const auto turn = [&](const Vec2& p) {
    return Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                std::sin(angle) * p.x() + std::cos(angle) * p.y());
  };
  Ring turned;
  for (const Vec2& p : test::box(0, 0, 200, 120)) turned.push_back(turn(p));
  const PlanarMesh straight = planar_mesh(box_area(0, 0, 200, 120), {.hypotenuse_m = 25.6});
  const PlanarMesh oblique = planar_mesh(from_rings({turned}, true), {.hypotenuse_m = 25.6});
  EXPECT_EQ(straight.faces.size(), oblique.faces.size());
  EXPECT_NEAR(total_area(straight), total_area(oblique), 1.0);
}

TEST(PlanarMesh, TheSameAreaGivesTheSameMesh) {
  const Area area = outline(harbour());
  const PlanarMesh a = planar_mesh(area, {.hypotenuse_m = 30});
  const PlanarMesh b = planar_mesh(area, {.hypotenuse_m = 30});
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_TRUE(a.vertices == b.vertices);
}

TEST(PlanarMesh, BadInputIsRefused) {
  EXPECT_THROW(static_cast<void>(planar_mesh({}, {.hypotenuse_m = 10})), InvalidInput);
  EXPECT_THROW(static_cast<void>(planar_mesh(box_area(0, 0, 1, 1), {.hypotenuse_m = 0})),
               UsageError);
}

}  // namespace
}  // namespace swathplan

#include "coverage/tracing/ray_scene.h"

#include <gtest/gtest.h>

#include <optional>

#include "coverage/scenes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::add_plate;
using testing::direction;
using testing::trace_one;

TEST(RayScene, FlatFloorIsHitAtDepthOverCosine) {
  const Seafloor s = flat(400, 400, 10.0);
  const RayScene scene(s, Nodata::open);
  for (double t = -80; t <= 80; t += 0.5) {
    const RayHit hit = trace_one(scene, {200.3, 199.7, -0.5}, direction(37, t));
    EXPECT_NEAR(hit.range_m, 9.5 / std::cos(Angle::degrees(t).rad()), 1e-4) << t;
    EXPECT_NEAR(hit.nz, 1.0F, 1e-6F);
  }
}

TEST(RayScene, TiltedFloorIsHitWhereTheClosedFormSays) {
  const Angle slope = Angle::degrees(20);
  const Seafloor s = tilted(200, 200, 5.0, slope);
  const RayScene scene(s, Nodata::open);
  const double x = 80.0;
  const double depth = 5.0 + x * tan(slope);
  for (double t = 1; t <= 60; t += 1) {
    const double cot = 1.0 / std::tan(Angle::degrees(t).rad());
    const RayHit down = trace_one(scene, {x, 100.1, 0}, direction(90, t));
    const RayHit up = trace_one(scene, {x, 100.1, 0}, direction(270, t));
    const double across = std::sin(Angle::degrees(t).rad());
    EXPECT_NEAR(up.range_m * across, depth / (cot + tan(slope)), 2e-3) << t;
    if (depth / (cot - tan(slope)) > 115) continue;
    EXPECT_NEAR(down.range_m * across, depth / (cot - tan(slope)), 5e-3) << t;
  }
}

TEST(RayScene, AStepThrowsAShadowAsLongAsGeometrySays) {
  // The boat 10 m west of the edge, 5 m of water over the shelf, 20 m beyond it: the grazing beam
  // lands 30 m beyond the edge, and no beam lands nearer.
  const Seafloor s = stepped(200, 100, 5.0, 20.0);
  const RayScene scene(s, Nodata::open);
  double nearest = 1e9;
  for (double t = 1; t < 85; t += 0.01) {
    const RayHit hit = trace_one(scene, {90.0, 50.03, 0}, direction(90, t));
    if (!(hit.range_m > 0)) continue;
    const double x = 90.0 + hit.range_m * std::sin(Angle::degrees(t).rad());
    if (hit.nz > 0.99 && x > 101) nearest = std::min(nearest, x);
  }
  EXPECT_NEAR(nearest, 130.0, 0.5);
}

TEST(RayScene, ABeamFromBelowGivesNothing) {
  const Seafloor s = stepped(200, 100, 5.0, 20.0);
  const RayScene scene(s, Nodata::open);
  EXPECT_EQ(trace_one(scene, {50, 50.3, -6.0}, direction(90, 100)).range_m, 0.0F);
  EXPECT_EQ(trace_one(scene, {50, 50.3, -6.0}, direction(0, 10)).range_m, 0.0F);
  EXPECT_GT(trace_one(scene, {50, 50.3, -4.9}, direction(0, 10)).range_m, 0.0F);
}

// Two basins with a quay of 4 m between them.
Seafloor two_basins() {
  Seafloor s;
  add_plate(s, 0, 0, 50, 50, 10);
  add_plate(s, 54, 0, 104, 50, 10);
  return s;
}

TEST(RayScene, ABeamThatLeavesTheDataIsStoppedByAWall) {
  const Seafloor s = two_basins();
  const RayScene wall(s, Nodata::wall);
  const RayScene open(s, Nodata::open);
  const Vec3 boat(48, 20.3, -0.3);
  const Eigen::Vector3f over = direction(90, 60);  // lands 16.8 m off, in the other basin
  EXPECT_EQ(trace_one(wall, boat, over).range_m, 0.0F);
  EXPECT_NEAR(trace_one(open, boat, over).range_m, 9.7 / 0.5, 1e-3);
  const Eigen::Vector3f inside = direction(90, 10);
  EXPECT_NEAR(trace_one(wall, boat, inside).range_m, trace_one(open, boat, inside).range_m, 1e-4);
}

TEST(RayScene, ABoatOutsideTheDataLooksIn) {
  const Seafloor s = two_basins();
  const RayScene wall(s, Nodata::wall);
  EXPECT_NEAR(trace_one(wall, {-3, 20.3, 0}, direction(90, 45)).range_m, 10 * std::sqrt(2.0), 1e-3);
  // On the quay it sees both basins, and out of the second it sees no farther.
  EXPECT_GT(trace_one(wall, {52, 20.3, 0}, direction(90, 45)).range_m, 0.0F);
  EXPECT_GT(trace_one(wall, {52, 20.3, 0}, direction(270, 45)).range_m, 0.0F);
  EXPECT_EQ(trace_one(wall, {-30, 20.3, 0}, direction(90, 83.6)).range_m, 0.0F);
}

TEST(RayScene, ABoatExactlyAboveTheBorderLooksInButNotOut) {
  Seafloor s;
  add_plate(s, 0, 0, 30, 30, 10);
  add_plate(s, 31, 0, 61, 30, 10);
  const RayScene wall(s, Nodata::wall);
  for (double t = 30; t < 70; t += 1) {
    EXPECT_EQ(trace_one(wall, {30, 15.2, 0}, direction(90, t)).range_m, 0.0F) << t;
    EXPECT_GT(trace_one(wall, {30, 15.2, 0}, direction(270, t)).range_m, 0.0F) << t;
  }
}

// First hit in double precision over all triangles.
struct Oracle {
  const Seafloor& s;
  [[nodiscard]] std::optional<std::pair<double, bool>> operator()(const Vec3& o,
                                                                  const Vec3& d) const {
    std::optional<std::pair<double, bool>> best;
    for (const Seafloor::Face& f : s.faces) {
      const Vec3 a = s.vertices[f[0]];
      const Vec3 e1 = s.vertices[f[1]] - a;
      const Vec3 e2 = s.vertices[f[2]] - a;
      const Vec3 p = d.cross(e2);
      const double det = e1.dot(p);
      if (det == 0.0) continue;
      const double u = (o - a).dot(p) / det;
      const Vec3 q = (o - a).cross(e1);
      const double v = d.dot(q) / det;
      const double t = e2.dot(q) / det;
      if (u < 0 || v < 0 || u + v > 1 || t <= 0) continue;
      if (!best || t < best->first) best = {t, d.dot(e1.cross(e2)) < 0};
    }
    return best;
  }
};

double oracle_range(const Oracle& oracle, const Vec3& o, const Vec3& d) {
  const auto hit = oracle(o, d);
  return hit && hit->second ? hit->first : 0.0;
}

void compare_with_oracle(const Vec2& at) {
  const Seafloor s = testing::rough_floor(14, 0.1, 7, at);
  const RayScene scene(s, Nodata::open);
  const Oracle oracle{s};
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 o(at.x() + 13 * uniform(), at.y() + 13 * uniform(), -4.0 - 6.0 * uniform());
    const Eigen::Vector3f df = direction(360 * uniform(), 85 * uniform());
    const Vec3 d = df.cast<double>().normalized();
    const double expected = oracle_range(oracle, o, d);
    // At a silhouette, or beside a face it starts in, the last bit decides: not compared.
    bool settled = true;
    for (const Vec3& nudge :
         {Vec3(1e-4, 0, 0), Vec3(-1e-4, 0, 0), Vec3(0, 1e-4, 0), Vec3(0, -1e-4, 0)}) {
      const double other = oracle_range(oracle, o + 20 * nudge, (d + nudge).normalized());
      settled = settled && std::abs(other - expected) < 0.05;
    }
    if (!settled) continue;
    ++compared;
    EXPECT_NEAR(trace_one(scene, o, df).range_m, expected, 2e-3) << i;
  }
  EXPECT_GT(compared, 750);
}

TEST(RayScene, AgreesWithALoopOverAllTriangles) { compare_with_oracle({0, 0}); }

TEST(RayScene, LargeLocalCoordinatesLoseNothing) { compare_with_oracle({5200.7, -7300.2}); }

TEST(RayScene, BeamsAimedAtVerticesAndEdgesDoNotSlipThrough) {
  // Gentle enough that the boat sees every face from above.
  Seafloor s = testing::rough_floor(40, 0.0, 11, {0, 0});
  for (Vec3& v : s.vertices) v.z() = -12.0 + 0.05 * v.z();
  const RayScene scene(s, Nodata::open);
  std::vector<Eigen::Vector3f> beams;
  const Vec3 o(19.3, 18.9, 0);
  for (std::size_t i = 0; i < s.faces.size(); ++i) {
    const Vec3& a = s.vertices[s.faces[i][0]];
    const Vec3& b = s.vertices[s.faces[i][1]];
    if ((a - o).head<2>().norm() > 15 || (b - o).head<2>().norm() > 15) continue;
    beams.push_back((a - o).normalized().cast<float>());
    beams.push_back((0.5 * (a + b) - o).normalized().cast<float>());
  }
  std::vector<RayHit> hits(beams.size());
  scene.trace(o, beams, hits);
  ASSERT_GT(beams.size(), 1000U);
  for (std::size_t i = 0; i < hits.size(); ++i) EXPECT_GT(hits[i].range_m, 0.0F) << i;
}

}  // namespace
}  // namespace swathplan

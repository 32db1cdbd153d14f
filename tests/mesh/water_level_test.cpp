#include "mesh/water_level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "mesh/synthetic.h"

namespace swathplan {
namespace {

double area_seen_from_above(const Seafloor& s) {
  double twice = 0.0;
  for (const Seafloor::Face& f : s.faces) {
    const Vec2 ab = (s.vertices[f[1]] - s.vertices[f[0]]).head<2>();
    const Vec2 ac = (s.vertices[f[2]] - s.vertices[f[0]]).head<2>();
    twice += ab.x() * ac.y() - ab.y() * ac.x();
  }
  return 0.5 * twice;
}

/// Edges with one face, by their vertices.
std::size_t edges_of_one_face(const Seafloor& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Seafloor::Face& f : s.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = f.at(i);
      const std::uint32_t b = f.at((i + 1) % 3);
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  }
  std::size_t border = 0;
  for (const auto& [edge, n] : uses) border += n == 1 ? 1 : 0;
  return border;
}

/// A 20 x 20 sheet of unit squares with the given heights.
template <class Height>
Seafloor sheet(Height height) {
  constexpr std::uint32_t kSide = 20;
  Seafloor s;
  for (std::uint32_t j = 0; j <= kSide; ++j) {
    for (std::uint32_t i = 0; i <= kSide; ++i) s.vertices.emplace_back(i, j, height(i, j));
  }
  for (std::uint32_t j = 0; j < kSide; ++j) {
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const std::uint32_t v = j * (kSide + 1) + i;
      s.faces.push_back({v, v + 1, v + kSide + 2});
      s.faces.push_back({v, v + kSide + 2, v + kSide + 1});
    }
  }
  return s;
}

TEST(WaterLevel, PlaneIsCutAlongItsShoreline) {
  // z = x - 7.25: under water for x < 7.25, so 7.25 of 20 columns.
  const Seafloor s = sheet([](double i, double) { return i - 7.25; });
  const Seafloor wet = below_level(s, 0.0);
  EXPECT_NEAR(area_seen_from_above(wet), 7.25 * 20.0, 1e-9);
  EXPECT_NEAR(area_seen_from_above(below_level(s, 3.0)), 10.25 * 20.0, 1e-9);
}

TEST(WaterLevel, NoVertexIsAboveAndKeptOnesAreUnmoved) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(-5.0, 5.0);
  const Seafloor s = sheet([&](double, double) { return height(random); });
  const Seafloor wet = below_level(s, 0.0);
  std::map<std::pair<double, double>, double> before;
  for (const Vec3& v : s.vertices) before[{v.x(), v.y()}] = v.z();
  for (const Vec3& v : wet.vertices) {
    EXPECT_LE(v.z(), 0.0);
    if (v.z() == 0.0) continue;
    const auto old = before.find({v.x(), v.y()});
    ASSERT_NE(old, before.end());
    EXPECT_EQ(old->second, v.z());
  }
}

TEST(WaterLevel, PartsBelowAndAboveMakeTheWhole) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> height(-5.0, 5.0);
  const Seafloor s = sheet([&](double, double) { return height(random); });
  Seafloor upside_down = s;
  for (Vec3& v : upside_down.vertices) v.z() = -v.z();
  EXPECT_NEAR(area_seen_from_above(below_level(s, 0.0)) +
                  area_seen_from_above(below_level(upside_down, 0.0)),
              400.0, 1e-9);
}

TEST(WaterLevel, NoCrackOpensWhereFacesWereCut) {
  // One bowl: the only border of the wet part is its shoreline, a closed loop of cut edges.
  const Seafloor s = sheet([](double i, double j) { return std::hypot(i - 10.1, j - 9.9) - 6.3; });
  const Seafloor wet = below_level(s, 0.0);
  std::size_t on_shore = 0;
  for (const Vec3& v : wet.vertices) on_shore += v.z() == 0.0 ? 1 : 0;
  EXPECT_GT(on_shore, 20U);
  EXPECT_EQ(edges_of_one_face(wet), on_shore);
}

TEST(WaterLevel, AllWaterStaysAndAllLandGoes) {
  const Seafloor s = saddle();
  EXPECT_EQ(below_level(s, 0.0).faces.size(), s.faces.size());
  EXPECT_NEAR(area_seen_from_above(below_level(s, 0.0)), area_seen_from_above(s), 1e-9);
  EXPECT_TRUE(below_level(s, -1000.0).faces.empty());
  EXPECT_TRUE(below_level(s, -1000.0).vertices.empty());
}

TEST(WaterLevel, TouchingTheLevelFromAboveIsLand) {
  Seafloor s;
  s.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 2), Vec3(0, -1, -2)};
  s.faces = {{0, 1, 2}, {1, 0, 3}};
  const Seafloor wet = below_level(s, 0.0);
  ASSERT_EQ(wet.faces.size(), 1U);
  EXPECT_EQ(wet.vertices.size(), 3U);
}

TEST(WaterLevel, NearlyDryCornersLeaveNoFaceWithoutArea) {
  Seafloor s;
  s.vertices = {Vec3(500000.1, 0, -1e-300), Vec3(500001, 0, 1), Vec3(500000, 1, 2),
                Vec3(500000, -1, -2)};
  s.faces = {{0, 1, 2}, {1, 0, 3}};
  const Seafloor wet = below_level(s, 0.0);
  for (const Seafloor::Face& f : wet.faces) {
    const Vec3 ab = wet.vertices[f[1]] - wet.vertices[f[0]];
    const Vec3 ac = wet.vertices[f[2]] - wet.vertices[f[0]];
    EXPECT_GT(std::abs(ab.x() * ac.y() - ab.y() * ac.x()), 0.0);
  }
}

}  // namespace
}  // namespace swathplan

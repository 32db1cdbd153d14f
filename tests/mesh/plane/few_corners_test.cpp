#include "mesh/plane/few_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::box;

constexpr double kTolerance = 0.1;

/// A closed line of `corners` points around (0, 0), with waves of several lengths.
Ring shoreline(int corners, double radius_m) {
  Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double a = 2.0 * std::numbers::pi * k / corners;
    const double r = radius_m * (1.0 + 0.1 * std::sin(5.0 * a) + 0.01 * std::sin(71.0 * a)) +
                     0.01 * std::sin(1e4 * a * a);
    ring.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return ring;
}

/// Teeth narrower than the tolerance, 20 m long.
Ring comb(int teeth) {
  Ring ring{{0, 0}, {0.1 * teeth, 0}};
  for (int k = teeth; k-- > 0;) {
    for (const Vec2& p : {Vec2(0.1 * k + 0.1, 20), Vec2(0.1 * k + 0.05, 20),
                          Vec2(0.1 * k + 0.05, 1), Vec2(0.1 * k, 1)}) {
      ring.push_back(p);
    }
  }
  return ring;
}

/// Rays from a middle, each a triangle.
Ring star(int rays) {
  Ring ring;
  for (int k = 0; k < 2 * rays; ++k) {
    const double a = std::numbers::pi * k / rays;
    const double r = k % 2 == 0 ? 8.0 : 1.0;
    ring.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return ring;
}

std::size_t all_corners(const Area& area) {
  std::size_t corners = 0;
  for (const Polygon& polygon : area) {
    corners += polygon.outer.size() + corners_of(polygon.holes);
  }
  return corners;
}

/// Both areas lie on their side of the rings and no farther off than the tolerance.
void expect_bracket(const std::vector<Ring>& rings, const Bracket& found) {
  constexpr double kDustM2 = 1e-6;
  const Area original = from_rings(rings, false);
  EXPECT_LT(area_m2(subtract(original, found.around)), kDustM2);
  EXPECT_LT(area_m2(subtract(found.within, original)), kDustM2);
  for (const Area& area : {found.around, found.within}) {
    for (const Polygon& polygon : area) {
      for (std::size_t k = 0; k < polygon.outer.size(); k += 7) {
        EXPECT_LT(distance_to_outline(original, polygon.outer[k]), kTolerance);
      }
    }
  }
}

TEST(FewCorners, EveryCornerLiesNearItsChord) {
  const Ring ring = shoreline(3000, 50.0);
  const Ring few = few_corners(ring, 0.05);
  EXPECT_LT(few.size(), ring.size() / 4);
  const Area chords{{few, {}}};
  for (const Vec2& p : ring) EXPECT_LT(distance_to_outline(chords, p), 0.05 + 1e-9);
}

TEST(FewCorners, KeepsASpikeThatIsLongerThanTheTolerance) {
  const Ring spike{{0, 0}, {5, 0}, {5.01, 9}, {5.02, 0}, {10, 0}, {10, -5}, {0, -5}};
  const Ring few = few_corners(spike, 0.1);
  EXPECT_NE(std::find(few.begin(), few.end(), Vec2(5.01, 9)), few.end());
}

TEST(FewCorners, AChordDoesNotLeaveOutAWayThereAndBack) {
  const Ring back{{0, 0}, {10, 0}, {5, 0.001}, {20, 0}, {20, 5}, {0, 5}};
  const Area chords{{few_corners(back, 0.1), {}}};
  for (const Vec2& p : back) EXPECT_LT(distance_to_outline(chords, p), 0.1 + 1e-9);
}

TEST(FewCorners, BracketsAShorelineWithAnIsland) {
  Ring island = shoreline(2000, 10.0);
  std::reverse(island.begin(), island.end());
  const std::vector<Ring> rings{shoreline(3000, 50.0), island};
  const Bracket found = bracket(rings, kTolerance);
  expect_bracket(rings, found);
  ASSERT_EQ(found.within.size(), 1U);
  EXPECT_EQ(found.within[0].holes.size(), 1U);
  ASSERT_EQ(found.around.size(), 1U);
  EXPECT_EQ(found.around[0].holes.size(), 1U);
}

TEST(FewCorners, CornersDependOnTheShapeNotOnTheFile) {
  const auto corners = [](int n) {
    return all_corners(bracket({shoreline(n, 50.0)}, kTolerance).within);
  };
  EXPECT_LT(corners(40000), 2 * corners(4000));
}

TEST(FewCorners, FillsOrDropsWhatIsThinnerThanTheTolerance) {
  const std::vector<Ring> rings{comb(200)};
  const Bracket found = bracket(rings, kTolerance);
  expect_bracket(rings, found);
  EXPECT_LT(all_corners(found.around), 20U);
  EXPECT_LT(all_corners(found.within), 20U);
  EXPECT_TRUE(contains(found.around, {10.08, 10})) << "between two teeth";
  EXPECT_FALSE(contains(found.within, {10.02, 10})) << "in a tooth";
}

TEST(FewCorners, BracketsAStarOfManyRays) {
  const std::vector<Ring> rings{star(400)};
  expect_bracket(rings, bracket(rings, kTolerance));
}

TEST(FewCorners, KeepsAWholeSliverInTheAreaAround) {
  const std::vector<Ring> sliver{box(0, 0, 0.01, 50)};
  const Bracket found = bracket(sliver, kTolerance);
  expect_bracket(sliver, found);
  EXPECT_TRUE(found.within.empty());
  EXPECT_EQ(found.around.size(), 1U);
}

}  // namespace
}  // namespace swathplan

#include "mesh/plane/polygons.h"

#include <gtest/gtest.h>

#include "mesh/plane/area_query.h"
#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::blob;
using test::box;
using test::box_area;

TEST(Polygons, BooleanAreasAddUp) {
  const Area a = box_area(0, 0, 10, 10);
  const Area b = box_area(5, 5, 20, 8);
  EXPECT_NEAR(area_m2(unite(a, b)), 100 + 45 - 15, 1e-6);
  EXPECT_NEAR(area_m2(intersect(a, b)), 15, 1e-6);
  EXPECT_NEAR(area_m2(subtract(a, b)), 85, 1e-6);
  EXPECT_NEAR(area_m2(unite(a, b)), area_m2(a) + area_m2(b) - area_m2(intersect(a, b)), 1e-6);
}

TEST(Polygons, HolesKeepTheirIslands) {
  const Area ring = subtract(box_area(0, 0, 10, 10), box_area(2, 2, 8, 8));
  const Area nested = unite(ring, box_area(4, 4, 6, 6));
  ASSERT_EQ(nested.size(), 2U);
  EXPECT_EQ(nested[0].holes.size(), 1U);
  EXPECT_NEAR(area_m2(nested), 100 - 36 + 4, 1e-6);
  EXPECT_GT(signed_area(nested[0].outer), 0.0);
  EXPECT_LT(signed_area(nested[0].holes[0]), 0.0);
  EXPECT_TRUE(contains(nested, {5, 5}));
  EXPECT_FALSE(contains(nested, {3, 3}));
  EXPECT_TRUE(contains(nested, {2, 5})) << "on the outline";
}

/// Squares of 2 m, 5 m apart, with holes of 1 m in them.
Area many_squares(int rows) {
  Area area;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Ring hole = box(5 * i + 0.5, 5 * j + 0.5, 5 * i + 1.5, 5 * j + 1.5);
      area.push_back({box(5 * i, 5 * j, 5 * i + 2, 5 * j + 2), {Ring(hole.rbegin(), hole.rend())}});
    }
  }
  return area;
}

TEST(Polygons, OffsetOfVeryManyRingsIsThatOfEach) {
  const int rows = 25;  // 1250 rings
  const Area squares = many_squares(rows);
  const Area one{squares.front()};
  for (const double distance : {0.3, 0.6, -0.2}) {
    EXPECT_NEAR(area_m2(offset(squares, distance)), rows * rows * area_m2(offset(one, distance)),
                0.01)
        << distance;
  }
  // Squares that grow together: nothing is left between them.
  EXPECT_EQ(offset(squares, 2.2).size(), 1U);
  EXPECT_TRUE(offset(squares, 2.2).front().holes.empty());
  EXPECT_TRUE(offset(squares, -0.3).empty());
}

TEST(Polygons, WaterShrinksOffVeryManyIslands) {
  const int rows = 40;
  const Area water = subtract(box_area(-5, -5, 5 * rows, 5 * rows), many_squares(rows));
  const Area shrunk = offset(water, -0.4);
  for (const Polygon& polygon : shrunk) {
    for (const Ring& hole : polygon.holes) {
      EXPECT_GE(distance_to_outline(water, hole.front()), 0.4 - 0.021);
    }
  }
  EXPECT_LT(area_m2(subtract(shrunk, water)), 1e-6);
  EXPECT_EQ(shrunk.size(), 1U) << "ponds of 1 m in the squares are used up";
}

TEST(Polygons, OffsetOfASquareHasRoundCorners) {
  const Area grown = offset(box_area(0, 0, 10, 10), 2.0);
  EXPECT_NEAR(area_m2(grown), 100 + 4 * 20 + M_PI * 4, 0.2);
  EXPECT_NEAR(area_m2(offset(box_area(0, 0, 10, 10), -2.0)), 36, 1e-6);
  EXPECT_TRUE(offset(box_area(0, 0, 10, 10), -5.1).empty());
}

TEST(Polygons, LargeCoordinatesLoseNothing) {
  const Area a = box_area(480000, 6105000, 480010, 6105010);
  EXPECT_NEAR(area_m2(a), 100, 1e-6);
  EXPECT_NEAR(area_m2(intersect(a, box_area(480005, 6105000, 480100, 6105100))), 50, 1e-6);
}

TEST(Polygons, SimplifyStaysWithinItsTolerance) {
  const Area wavy = blob(0, 0, 50, 3);
  const Area simple = simplify(wavy, 1.0);
  EXPECT_LT(simple[0].outer.size(), wavy[0].outer.size());
  for (const Vec2& p : wavy[0].outer) EXPECT_LE(distance_to_outline(simple, p), 1.0 + 2 * kLattice);
}

TEST(Polygons, SegmentsAreCutAtTheOutline) {
  const Area ring = subtract(box_area(0, 0, 10, 10), box_area(4, 4, 6, 6));
  const auto parts = clip_segment(ring, {-5, 5}, {15, 5});
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].first, 0.25, 1e-9);
  EXPECT_NEAR(parts[0].second, 0.45, 1e-9);
  EXPECT_NEAR(parts[1].first, 0.55, 1e-9);
}

// The prepared query and the plain functions are two ways to the same answers.
TEST(Polygons, InnerPointLiesInsideRingsAndThinStrips) {
  const Area box = box_area(-50, -50, 50, 50);
  for (const double width : {0.05, 2.0, 40.0}) {
    const Area ring = subtract(box, offset(box, -width));
    const Vec2 p = inner_point(ring);
    EXPECT_TRUE(contains(ring, p)) << width << ": " << p.transpose();
  }
  EXPECT_LT(inner_point(box).norm(), 1e-9);
}

TEST(AreaQuery, AgreesWithThePlainFunctions) {
  const Area area = subtract(unite(blob(0, 0, 60, 1), blob(90, 20, 40, 2)), blob(10, 5, 15, 4));
  const AreaQuery query(area);
  std::mt19937_64 random(7);
  const auto coordinate = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p(coordinate(-120, 180), coordinate(-120, 120));
    const Vec2 q(coordinate(-120, 180), coordinate(-120, 120));
    EXPECT_NEAR(query.distance(p), distance_to_outline(area, p), 1e-9);
    if (query.distance(p) > 1e-3) {
      EXPECT_EQ(query.contains(p), contains(area, p));
    }
    double inside = 0.0;
    for (const auto& [t0, t1] : clip_segment(area, p, q)) inside += (t1 - t0) * (q - p).norm();
    EXPECT_NEAR(query.inside_length(p, q), inside, 1e-6) << p.transpose() << " - " << q.transpose();
  }
}

TEST(AreaQuery, EmptyAreaHoldsNothing) {
  const AreaQuery query(Area{});
  EXPECT_FALSE(query.contains({0, 0}));
  EXPECT_EQ(query.inside_length({0, 0}, {1, 1}), 0.0);
}

}  // namespace
}  // namespace swathplan

#include "io/mosaic/zipped.h"

#include <gtest/gtest.h>

#include "mesh/survey_area.h"

namespace swathplan {
namespace {

/// A lattice of squares at a depth.
Seafloor lattice(double x0, double y0, double step, int columns, int rows, double depth) {
  Seafloor s;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      s.vertices.emplace_back(x0 + i * step, y0 + j * step, -depth);
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      s.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

/// One piece of water without a slit or a hole, of this area.
void expect_whole(const Zipped& zip, double m2) {
  const Area water = outline(zip.seafloor);
  ASSERT_EQ(water.size(), 1U);
  EXPECT_TRUE(water[0].holes.empty());
  EXPECT_NEAR(area_m2(water), m2, 1e-6 * m2);
  EXPECT_NEAR(plan_area_m2(zip.seafloor), m2, 1e-6 * m2);  // no two faces above each other
  EXPECT_NEAR(zip.upper_m2 + zip.lower_m2, m2, 1e-6 * m2);
}

TEST(Zipped, AFineSurfaceReplacesThePartOfACoarseOne) {
  const Seafloor fine = lattice(31, 33, 1, 30, 20, 7);
  const Seafloor coarse = lattice(0, 0, 10, 10, 10, 8);
  const Zipped zip = zipped(fine, coarse, 16);
  expect_whole(zip, 1e4);
  EXPECT_DOUBLE_EQ(zip.upper_m2, 600.0);
  const DepthQuery depths(zip.seafloor);
  EXPECT_NEAR(depths.depth({45, 45}).value(), 7.0, 1e-12);
  EXPECT_NEAR(depths.depth({5, 5}).value(), 8.0, 1e-12);
  const double between = depths.depth({30.5, 45}).value();
  EXPECT_GT(between, 7.0);
  EXPECT_LT(between, 8.0);
  ASSERT_EQ(zip.steps_m.size(), 100U);
  for (const double step : zip.steps_m) EXPECT_NEAR(step, 1.0, 1e-12);
}

TEST(Zipped, APieceWithinOneCoarseFaceIsFoundToo) {
  expect_whole(zipped(lattice(52, 51, 0.5, 4, 2, 7), lattice(0, 0, 50, 2, 2, 8), 80), 1e4);
}

TEST(Zipped, NeighbouringTilesAreBridged) {
  const Seafloor west = lattice(0, 0, 1, 19, 20, 7);
  const Seafloor east = lattice(20, 0, 1, 20, 20, 7);
  const Zipped zip = zipped(west, east, 1.6);
  expect_whole(zip, 800.0);
  EXPECT_TRUE(zip.steps_m.empty());
}

TEST(Zipped, FarApartTheyStayApart) {
  const Zipped zip = zipped(lattice(0, 0, 1, 10, 10, 7), lattice(15, 0, 1, 10, 10, 7), 1.6);
  EXPECT_EQ(outline(zip.seafloor).size(), 2U);
  EXPECT_NEAR(plan_area_m2(zip.seafloor), 200.0, 1e-9);
}

TEST(Zipped, HolesOfTheUpperAreFilledByTheLower) {
  Seafloor upper = lattice(0, 0, 1, 20, 20, 7);
  std::erase_if(upper.faces, [&](const Seafloor::Face& f) {
    const Vec3 m = (upper.vertices[f[0]] + upper.vertices[f[1]] + upper.vertices[f[2]]) / 3.0;
    return m.x() > 8 && m.x() < 12 && m.y() > 8 && m.y() < 12;
  });
  const Zipped zip = zipped(upper, lattice(0, 0, 5, 4, 4, 8), 8);
  expect_whole(zip, 400.0);
  EXPECT_NEAR(zip.lower_m2, 16.0, 1e-9);
}

TEST(Zipped, WhereTheUpperCoversAllItAloneStays) {
  const Seafloor upper = lattice(-5, -5, 1, 30, 30, 7);
  const Zipped zip = zipped(upper, lattice(0, 0, 5, 4, 4, 8), 8);
  EXPECT_EQ(zip.seafloor.faces.size(), upper.faces.size());
  EXPECT_EQ(zip.lower_m2, 0.0);
}

}  // namespace
}  // namespace swathplan

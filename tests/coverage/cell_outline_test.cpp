#include "coverage/cell_outline.h"

#include <gtest/gtest.h>

#include <random>

namespace swathplan {
namespace {

/// Rows from the north; '#' belongs to the set.
std::vector<RowRun> runs_of(const std::vector<std::string>& rows) {
  std::vector<RowRun> runs;
  for (std::uint32_t r = 0; r < rows.size(); ++r) {
    const std::string& row = rows[rows.size() - 1 - r];
    for (std::uint32_t c = 0; c < row.size(); ++c) {
      if (row[c] != '#') continue;
      const std::uint32_t first = c;
      while (c < row.size() && row[c] == '#') ++c;
      runs.push_back({r, first, c});
    }
  }
  return runs;
}

TEST(CellOutline, OfOneCellIsItsSquare) {
  const Polygon square = cell_outline({{3, 2, 3}}, Vec2(10.0, 20.0), 0.5);
  EXPECT_TRUE(square.holes.empty());
  ASSERT_EQ(square.outer.size(), 4U);
  EXPECT_NEAR(signed_area(square.outer), 0.25, 1e-12);
  EXPECT_EQ(extent({square}).min, Vec2(11.0, 21.5));
}

TEST(CellOutline, OfNoCellsHasNoPoints) {
  EXPECT_TRUE(cell_outline({}, Vec2::Zero(), 1.0).outer.empty());
}

TEST(CellOutline, KeepsHolesAndStraightSidesWhole) {
  const Polygon ring = cell_outline(runs_of({"####", "#..#", "####"}), Vec2::Zero(), 1.0);
  EXPECT_EQ(ring.outer.size(), 4U);
  ASSERT_EQ(ring.holes.size(), 1U);
  EXPECT_EQ(ring.holes[0].size(), 4U);
  EXPECT_NEAR(area_m2({ring}), 10.0, 1e-12);
  EXPECT_NEAR(signed_area(ring.holes[0]), -2.0, 1e-12);
  EXPECT_EQ(corner_count(ring), 8U);
}

TEST(CellOutline, KeepsApartWhatOnlyCornersJoin) {
  // The hole touches the outside by a corner, and so do two holes each other.
  const Polygon open = cell_outline(runs_of({"###.", "#.##", "####"}), Vec2::Zero(), 1.0);
  ASSERT_EQ(open.holes.size(), 1U);
  EXPECT_EQ(open.holes[0].size(), 4U);
  EXPECT_EQ(open.outer.size(), 6U);
  const Polygon two = cell_outline(runs_of({"####", "#.##", "##.#", "####"}), Vec2::Zero(), 1.0);
  EXPECT_EQ(two.holes.size(), 2U);
}

TEST(CellOutline, HoldsExactlyTheCellsOfRandomSets) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 40; ++trial) {
    // A frame and a comb of full rows keep any set of cells between them connected by sides.
    std::vector<std::string> rows(13, std::string(17, '#'));
    for (std::size_t r = 1; r + 1 < rows.size(); r += 2) {
      for (std::size_t c = 1; c + 1 < rows[r].size(); ++c) {
        if (random() % 2 == 0) rows[r][c] = '.';
      }
    }
    const Polygon outline = cell_outline(runs_of(rows), Vec2::Zero(), 1.0);
    double cells = 0.0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < rows[r].size(); ++c) {
        const bool in = rows[rows.size() - 1 - r][c] == '#';
        cells += in ? 1.0 : 0.0;
        EXPECT_EQ(contains({outline}, Vec2(double(c) + 0.5, double(r) + 0.5)), in);
      }
    }
    EXPECT_NEAR(area_m2({outline}), cells, 1e-9);
  }
}

}  // namespace
}  // namespace swathplan

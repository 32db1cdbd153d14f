#include "planners/fronts/row_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "planners/fitted/line_workshop.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/two_basins.h"

namespace swathplan {
namespace {

using test::TwoBasins;

const Angle kEast = Angle::degrees(90.0);

std::vector<SurveyCurve> rows(LineWorkshop& shop, Angle azimuth) {
  return fitted_straight_lines(shop.raster(), shop.width(1.0), shop.survey_area(), shop.lines_in(),
                               {.azimuth = azimuth, .lines = 6});
}

TEST(RowBlocks, BeginWhereARowParts) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const auto lines = rows(shop, kEast);
  ASSERT_EQ(lines.size(), 9U);
  const RowBlocks blocks = row_blocks(lines, kEast, shop.raster());
  ASSERT_EQ(blocks.lines.size(), 3U);
  for (const auto& block : blocks.lines) EXPECT_EQ(block.size(), 3U);
}

TEST(RowBlocks, HaveEveryCellOfTheAreaAndNoOther) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const RowBlocks blocks = row_blocks(rows(shop, kEast), kEast, shop.raster());
  std::vector<std::size_t> cells(blocks.lines.size(), 0);
  for (std::size_t i = 0; i < shop.raster().size(); ++i) {
    ASSERT_EQ(blocks.of_cell[i] != RowBlocks::kNone, shop.raster().in_area(i));
    if (blocks.of_cell[i] >= 0) ++cells[static_cast<std::size_t>(blocks.of_cell[i])];
  }
  EXPECT_EQ(cells, blocks.cells);
  const auto block_at = [&](double x, double y) {
    return blocks.of_cell[shop.raster().cell_at({x, y}).value()];
  };
  EXPECT_EQ(block_at(1.0, 59.0), block_at(24.0, 33.0));
  EXPECT_EQ(block_at(36.0, 59.0), block_at(59.0, 33.0));
  EXPECT_EQ(block_at(1.0, 1.0), block_at(59.0, 27.0));
  EXPECT_NE(block_at(24.0, 40.0), block_at(36.0, 40.0));
  EXPECT_NE(block_at(24.0, 40.0), block_at(24.0, 20.0));
}

TEST(RowBlocks, AreOneWhereRowsRunToAndFro) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  EXPECT_TRUE(row_blocks({}, kEast, shop.raster()).lines.empty());
  const std::vector<SurveyCurve> lines{straight_curve({1.0, 5.0}, {59.0, 5.0}),
                                       straight_curve({59.0, 20.0}, {1.0, 20.0})};
  EXPECT_EQ(row_blocks(lines, kEast, shop.raster()).lines.size(), 1U);
}

TEST(RowBlocks, CutLinesAtTheCellsOfOthers) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const RowBlocks blocks = row_blocks(rows(shop, kEast), kEast, shop.raster());
  const std::vector<SurveyCurve> across{straight_curve({12.0, 1.0}, {12.0, 59.0})};
  double sum = 0.0;
  for (std::int32_t b = 0; b < 3; ++b) {
    const auto parts = cut_to_block(across, blocks, b, shop.raster(), 1.0);
    for (const SurveyCurve& part : parts) {
      sum += length_m(part);
      for (const Vec2& p : part.points) {
        EXPECT_EQ(blocks.of_cell[shop.raster().cell_at(p).value()], b);
      }
    }
  }
  EXPECT_NEAR(sum, 58.0, 2.0 * shop.raster().cell_m());
  EXPECT_TRUE(cut_to_block(across, blocks, 0, shop.raster(), 60.0).empty());
}

}  // namespace
}  // namespace swathplan

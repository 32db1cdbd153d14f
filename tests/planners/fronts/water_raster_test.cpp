#include "planners/fronts/water_raster.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(WaterRaster, CellsOfTheAreaAddUpToItInsideAFrame) {
  const TestSite site(flat(40.0, 30.0, 10.0));
  const WaterRaster raster(site.ground, 1e6, 0.5);
  EXPECT_EQ(raster.cell_m(), 0.5);
  std::size_t cells = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    EXPECT_EQ(raster.cell_at(raster.centre(i)), i);
    if (!raster.in_area(i)) continue;
    ++cells;
    EXPECT_NEAR(raster.depth(i), 10.0, 1e-5);
    const std::size_t column = i % raster.columns(), row = i / raster.columns();
    EXPECT_TRUE(column > 0 && column + 1 < raster.columns() && row > 0 && row + 1 < raster.rows());
  }
  EXPECT_EQ(cells, 80U * 60U);
  EXPECT_FALSE(raster.cell_at({-10.0, 5.0}).has_value());
}

TEST(WaterRaster, IsCoarserWhereCellsWouldBeTooMany) {
  const TestSite site(flat(40.0, 30.0, 10.0));
  EXPECT_DOUBLE_EQ(WaterRaster(site.ground, 300.0, 0.5).cell_m(), 2.0);
}

TEST(WaterRaster, LooksForDepthsThreeCellsAround) {
  const TestSite site(flat(40.0, 30.0, 10.0));
  const WaterRaster raster(site.ground, 1e6, 0.5);
  ASSERT_TRUE(raster.depth_near({-1.2, 15.0}).has_value());
  EXPECT_NEAR(*raster.depth_near({-1.2, 15.0}), 10.0, 1e-5);
  EXPECT_FALSE(raster.depth_near({-2.2, 15.0}).has_value());
}

TEST(WaterRaster, OnlyKeepsTheNamedCells) {
  const TestSite site(flat(40.0, 30.0, 10.0));
  const WaterRaster raster(site.ground, 1e6, 0.5);
  const auto kept = raster.cell_at({20.0, 15.0});
  ASSERT_TRUE(kept.has_value());
  std::vector<char> keep(raster.size(), 0);
  keep[*kept] = 1;
  const WaterRaster part = raster.only(keep);
  for (std::size_t i = 0; i < part.size(); ++i) EXPECT_EQ(part.in_area(i), i == *kept);
}

TEST(GapFreeWidth, OfFootprintsIsTheWholeFanUpToTheRange) {
  PlanOptions options;
  options.cover = Cover::footprint;
  options.sonar.max_opening = Angle::degrees(90.0);
  options.vehicle.draft_m = 0.5;
  EXPECT_NEAR(gap_free_width_m(options, 20.5, 0.1), 40.0, 1e-9);
  options.sonar.max_range_m = 25.0;
  EXPECT_NEAR(gap_free_width_m(options, 20.5, 0.1), 30.0, 1e-9);
}

TEST(WidthField, IsTheWidthOverFlatGround) {
  const TestSite site(tilted(60.0, 20.0, 8.0, Angle::degrees(10.0)));
  const WaterRaster raster(site.ground, 1e6, 1.0);
  PlanOptions options;
  options.resolution_m = 0.25;
  const auto widths = width_field(raster, options, 1.2);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    const double exact =
        raster.in_area(i) ? gap_free_width_m(options, raster.depth(i), 1.2 * 0.25) : 0.0;
    EXPECT_NEAR(static_cast<double>(widths[i]), exact, 1e-3 * exact);
  }
}

}  // namespace
}  // namespace swathplan

#include "planners/fronts/headland.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

Area box_to(double x, double y) { return {{{{0, 0}, {x, 0}, {x, y}, {0, y}}, {}}}; }

TEST(Headland, WallsAreWhereNoWaterLiesBeyond) {
  // A basin whose eastern side is open water.
  const Area basin = box_to(60, 40);
  const AreaQuery water(box_to(90, 40));
  const auto walls = walls_without_room(basin, water, 10.0, 1.0);
  double metres = 0.0;
  for (const SurveyCurve& wall : walls) {
    metres += length_m(wall);
    for (std::size_t i = 0; i + 1 < wall.points.size(); ++i) {
      const Vec2 middle = 0.5 * (wall.points[i] + wall.points[i + 1]);
      EXPECT_FALSE(middle.x() > 59.9 && middle.y() > 1.0 && middle.y() < 39.0) << middle.y();
    }
  }
  EXPECT_NEAR(metres, 60.0 + 40.0 + 60.0, 1.0);
}

TEST(Headland, LinesLieHalfASwathOffTheWallAndLeaveTheRest) {
  const TestSite site(flat(120.0, 80.0, 10.0));
  const WaterRaster raster(site.ground);
  std::vector<float> width(raster.size(), 0.0F);
  for (std::size_t i = 0; i < raster.size(); ++i) width[i] = raster.in_area(i) ? 20.0F : 0.0F;
  const Headland headland =
      headland_along({straight_curve({0, 0}, {120, 0})}, raster, width, {.step_m = 1.0});
  ASSERT_FALSE(headland.lines.empty());
  for (const SurveyCurve& line : headland.lines) {
    for (const Vec2& p : line.points) EXPECT_NEAR(p.y(), 10.0, 1.0);
  }
  for (const double y : {5.0, 15.0, 25.0, 75.0}) {
    const auto cell = raster.cell_at({60.0, y});
    ASSERT_TRUE(cell);
    EXPECT_EQ(headland.inner[*cell] != 0, y > 20.0) << y;
  }
}

}  // namespace
}  // namespace swathplan

#include "planners/fronts/level_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(LevelLines, OfAPlaneAreStraightAndWhole) {
  const TestSite g(flat(40.0, 30.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  std::vector<float> u(raster.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = raster.in_area(i) ? static_cast<float>(raster.centre(i).x())
                             : std::numeric_limits<float>::infinity();
  }
  const auto lines = level_lines(raster, u, 17.2);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length_m(lines[0]), 30.0, 1.01);
  for (const Vec2& p : lines[0].points) EXPECT_NEAR(p.x(), 17.2, 1e-4);
}

TEST(LevelLines, OfAConeAreOneClosedCircle) {
  const TestSite site(flat(40.0, 40.0, 10.0));
  const WaterRaster raster(site.ground, 1e6, 0.5);
  std::vector<float> u(raster.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = static_cast<float>((raster.centre(i) - Vec2(20.0, 20.0)).norm());
  }
  const auto lines = level_lines(raster, u, 8.3);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(is_closed(lines[0]));
  for (const Vec2& p : lines[0].points) EXPECT_NEAR((p - Vec2(20.0, 20.0)).norm(), 8.3, 0.01);
  EXPECT_NEAR(length_m(lines[0]), 2.0 * std::numbers::pi * 8.3, 0.1);
}

}  // namespace
}  // namespace swathplan

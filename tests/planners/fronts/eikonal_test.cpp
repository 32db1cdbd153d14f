#include "planners/fronts/eikonal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(Eikonal, CountsWidthsFromAPointOnEvenGround) {
  const TestSite g(flat(60.0, 60.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  const std::vector<float> width(raster.size(), 5.0F);
  const auto from = raster.cell_at({30.0, 30.0});
  ASSERT_TRUE(from.has_value());
  const Front front = march(raster, width, {{*from, 0.0, 7}});
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) {
      EXPECT_TRUE(std::isinf(front.u[i]));
      continue;
    }
    const double exact = (raster.centre(i) - raster.centre(*from)).norm() / 5.0;
    // First order: too long by the diagonal's error near the point, under 0.2 widths here.
    EXPECT_NEAR(static_cast<double>(front.u[i]), exact, 0.2);
    EXPECT_EQ(front.label[i], 7U);
  }
}

}  // namespace
}  // namespace swathplan

#include "planners/fronts/fitted_straight.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(FittedStraight, RowsStandCloserOverShoalGround) {
  const TestSite g(tilted(200.0, 120.0, 8.0, Angle::degrees(5.0)));
  const WaterRaster raster(g.ground);
  PlanOptions options;
  options.resolution_m = 0.25;
  const AreaQuery area(g.ground.survey_area);
  const auto lines = fitted_straight_lines(raster, width_field(raster, options, 1.0), area, area,
                                           {.azimuth = Angle::degrees(0.0), .lines = 6});
  ASSERT_EQ(lines.size(), 6U);
  double spacing = 0.0;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const double here = lines[k + 1].points[0].x() - lines[k].points[0].x();
    EXPECT_GT(here, spacing);
    spacing = here;
    EXPECT_NEAR(length_m(lines[k]), 119.9, 0.01);
  }
}

}  // namespace
}  // namespace swathplan

#include "planners/fronts/field_lines.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(FieldLines, SpacingFollowsTheWidthAndLengthItsIntegral) {
  const TestSite g(tilted(200.0, 120.0, 8.0, Angle::degrees(5.0)));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  PlanOptions options;
  options.resolution_m = 0.25;
  const std::vector<float> width = width_field(raster, options, 1.0);
  const FieldWall west{{0.0, 0.0}, {0.0, 120.0}};
  const AreaQuery area(g.ground.survey_area);
  double metres = 0.0;
  double before = 0.0;
  for (const SurveyCurve& line : field_lines(raster, width, area, west, 0.1)) {
    metres += length_m(line);
    const double x = line.points[line.points.size() / 2].x();
    EXPECT_GT(x, before);
    before = x;
  }
  // One line more or less.
  EXPECT_NEAR(metres, least_line_m(raster, width), 120.0);
}

}  // namespace
}  // namespace swathplan

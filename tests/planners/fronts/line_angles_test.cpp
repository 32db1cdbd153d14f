#include "planners/fronts/line_angles.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(LineAngles, SidesMeetTheNeighbourAndStopAtTheEdge) {
  const TestSite g(flat(60.0, 40.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.25);
  PlanOptions options;
  options.resolution_m = 0.25;
  options.vehicle.draft_m = 0.0;
  const std::vector<float> width(raster.size(), 100.0F);
  const AreaQuery area(g.ground.survey_area);
  // Northward at x = 10 and 30: port of the first sees 10 m to the edge, starboard 10 m half-way.
  const auto lines = opened_lines(
      {straight_curve({10.0, 0.5}, {10.0, 39.5}), straight_curve({30.0, 0.5}, {30.0, 39.5})},
      raster, width, area, options, {.overlap_m = 0.5, .widest_share = 1.0, .by_distance = false});
  ASSERT_EQ(lines.size(), 2U);
  const FanAngles fan = *lines[0][20].fan;
  EXPECT_NEAR(10.0 * tan(fan.port), 10.0, 0.05);
  EXPECT_NEAR(10.0 * tan(fan.starboard), 10.5, 0.3);
  EXPECT_NEAR(10.0 * tan(lines[1][20].fan->starboard), 30.0, 0.05);
}

TEST(LineAngles, ASideReachesPastTheBoundaryByAShareOfItsSwath) {
  const TestSite g(flat(60.0, 40.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.25);
  PlanOptions options;
  options.resolution_m = 0.25;
  options.vehicle.draft_m = 0.0;
  const std::vector<float> width(raster.size(), 40.0F);
  const AreaQuery area(g.ground.survey_area);
  const auto lines = opened_lines(
      {straight_curve({10.0, 0.5}, {10.0, 39.5}), straight_curve({30.0, 0.5}, {30.0, 39.5})},
      raster, width, area, options, {.overlap_m = 0.0, .overlap_share = 0.1});
  // Half-way is 10 m off, and a tenth of the swath is 4 m.
  EXPECT_NEAR(10.0 * tan(lines[0][20].fan->starboard), 14.0, 0.3);
}

TEST(LineAngles, AShadowIsTheOtherLinesToSee) {
  // A wall at x = 30 down to the deep east: from the shoal side its foot is hidden.
  const TestSite g(stepped(60.0, 40.0, 5.0, 30.0));
  const WaterRaster raster(g.ground, 1e6, 0.25);
  PlanOptions options;
  options.resolution_m = 0.25;
  const std::vector<float> width(raster.size(), 60.0F);
  const AreaQuery area(g.ground.survey_area);
  const auto lines = opened_lines(
      {straight_curve({24.0, 0.5}, {24.0, 39.5}), straight_curve({50.0, 0.5}, {50.0, 39.5})},
      raster, width, area, options, {.overlap_m = 0.5, .widest_share = 1.0, .by_distance = false});
  // Half-way is x = 37, but the first line sees no ground between x = 30 and about 60.
  const double reach = 29.7 * tan(lines[1][20].fan->port);
  EXPECT_GE(reach, 19.5);
}

}  // namespace
}  // namespace swathplan

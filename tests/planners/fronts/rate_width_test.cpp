#include "planners/fronts/rate_width.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

PlanOptions clocked() {
  PlanOptions options;
  options.pings.spacing_m.reset();
  options.sonar.max_opening = Angle::degrees(130);
  options.resolution_m = 0.5;
  return options;
}

TEST(RateWidth, IsTheSwathOfTheFastestFanOverTheDepthThere) {
  const TestSite site(flat(100.0, 80.0, 20.0));
  const WaterRaster raster(site.ground);
  const PlanOptions options = clocked();
  const double below = 20.0 - options.vehicle.draft_m;
  const auto best = best_area_rate(rate_question(options), below);
  ASSERT_TRUE(best);
  const double expected = 2.0 * below * tan(best->half_angle);
  for (const double overlap : {0.0, 0.1}) {
    const auto width = rate_width_field(raster, options, 1.0, overlap);
    for (std::size_t i = 0; i < raster.size(); ++i) {
      EXPECT_NEAR(width[i], raster.in_area(i) ? (1.0 - overlap) * expected : 0.0, 0.01 * expected);
    }
  }
}

TEST(RateWidth, AStretchWidensSwathsWhereBeamsWouldStandTooFarApart) {
  const TestSite site(flat(100.0, 80.0, 40.0));
  const WaterRaster raster(site.ground);
  const PlanOptions options = clocked();
  const auto narrow = rate_width_field(raster, options, 1.0, 0.0);
  const auto wide = rate_width_field(raster, options, 1.3, 0.0);
  const auto middle = raster.cell_at({50.0, 40.0});
  ASSERT_TRUE(middle);
  EXPECT_GT(wide[*middle], 1.05F * narrow[*middle]);
}

}  // namespace
}  // namespace swathplan

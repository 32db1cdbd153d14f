#include "planners/line_spacing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/rows/back_and_forth.h"
#include "planners/rows/multi_depth.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

/// A boat whose sonar hangs at the water line, so that depths are depths below the sonar.
PlanOptions fan_options(double opening_deg) {
  PlanOptions o;
  o.resolution_m = 1.0;  // W = 256 m: nothing may be laid by it
  o.vehicle.draft_m = 0.0;
  o.sonar.max_opening = Angle::degrees(opening_deg);
  o.rows.swath_by = SwathBy::fan;
  o.lane_width_m = 20.0;
  o.bands.count = 1;
  return o;
}

/// Metres between neighbouring logged lines that run east, ascending.
std::vector<double> gaps_between(const Route& route) {
  std::vector<double> rows, gaps;
  for (const Leg& leg : legs(route)) {
    if (route.waypoints[leg.first].log) rows.push_back(route.waypoints[leg.first].position.y());
  }
  std::sort(rows.begin(), rows.end());
  for (std::size_t i = 1; i < rows.size(); ++i) gaps.push_back(rows[i] - rows[i - 1]);
  return gaps;
}

TEST(LineSpacing, IsTwoDepthsTimesTheTangentLessTheOverlap) {
  PlanOptions o = fan_options(120.0);
  const BlockLines lines = lines_of_block({10.0, 10.0}, o);
  EXPECT_NEAR(lines.swath_m, 20.0 * std::tan(Angle::degrees(60).rad()), 1e-9);
  EXPECT_NEAR(lines.spacing_m, 0.9 * lines.swath_m, 1e-9);
  o.rows.overlap = 0.25;
  EXPECT_NEAR(lines_of_block({10.0}, o).spacing_m, 0.75 * lines.swath_m, 1e-9);
  o.vehicle.draft_m = 2.0;
  EXPECT_NEAR(lines_of_block({10.0}, o).swath_m, 0.8 * lines.swath_m, 1e-9);
  o.rows.spacing_m = 7.0;
  EXPECT_EQ(lines_of_block({10.0}, o).spacing_m, 7.0);
}

TEST(LineSpacing, TakesTheDepthThatIsAskedFor) {
  std::vector<double> depths;
  for (int i = 0; i <= 100; ++i) depths.push_back(10.0 + 0.1 * i * i);
  EXPECT_EQ(depth_of(depths, {}), 10.0);
  EXPECT_EQ(depth_of(depths, {.share = 0.1}), 20.0);
  EXPECT_NEAR(depth_of(depths, {.mean = true}), 10.0 + 0.1 * 3350.0, 1e-9);
  EXPECT_EQ(depth_of({}, {}), 0.0);
}

TEST(LineSpacing, TheFanEndsWithTheSonarsReach) {
  PlanOptions o = fan_options(130.0);
  o.sonar.max_range_m = 100.0;
  o.angles = Angles::ping;
  EXPECT_NEAR(lines_of_block({50.0}, o).fan.port.deg(), 60.0, 1e-6);
  o.sonar.coverage_curve = {{20.0, Angle::degrees(60)}, {60.0, Angle::degrees(20)}};
  EXPECT_NEAR(lines_of_block({40.0}, o).fan.port.deg(), 40.0, 1e-6);
  EXPECT_EQ(lines_of_block({120.0}, o).spacing_m, 0.0);
  o.sonar.coverage_curve.clear();
  o.angles = Angles::line;  // in whole degrees, never more than the sonar sees
  EXPECT_NEAR(lines_of_block({60.0}, o).fan.port.deg(), 53.0, 1e-9);
  o.opening_angle = Angle::degrees(90.0);
  EXPECT_NEAR(lines_of_block({60.0}, o).fan.port.deg(), 45.0, 1e-9);
}

TEST(LineSpacing, DepthsOfABlockAreThoseOfItsArea) {
  const TestSite site(tilted(100, 40, 10, Angle::degrees(10)));
  const auto depths = block_depths(site.ground.survey_area, site.depths);
  const double deepest = 10.0 + 100.0 * std::tan(Angle::degrees(10).rad());
  EXPECT_NEAR(depths.front(), 10.0, 0.1);
  EXPECT_NEAR(depths.back(), deepest, 0.1);
  EXPECT_NEAR(depth_of(depths, {.mean = true}), 0.5 * (10.0 + deepest), 0.05);
  EXPECT_TRUE(block_depths({}, site.depths).empty());
}

TEST(LineSpacing, BackAndForthLiesByTheShoalestWater) {
  const TestSite site(tilted(300, 300, 10, Angle::degrees(4)));
  PlanOptions o = fan_options(120.0);
  o.heading = Angle::degrees(90.0);
  const Plan plan = plan_back_and_forth(site.ground, o);
  const double swath = 20.0 * std::tan(Angle::degrees(60).rad());
  const auto gaps = gaps_between(plan.route);
  ASSERT_EQ(gaps.size() + 1, 1 + std::ceil((300.0 - swath) / (0.9 * swath)));
  for (const double gap : gaps) EXPECT_NEAR(gap, 0.9 * swath, 0.02 * swath);
  EXPECT_NEAR(plan.openings.at(0).deg(), 120.0, 1e-9);
  EXPECT_THAT(plan.notes.back(), HasSubstr("an overlap of 10 %"));
  EXPECT_THAT(plan.notes.back(), HasSubstr("the shoalest water"));
}

TEST(LineSpacing, TheSpacingThatIsTypedIsTheSpacing) {
  const TestSite site(flat(300, 300, 10));
  PlanOptions o = fan_options(120.0);
  o.heading = Angle::degrees(90.0);
  o.rows.spacing_m = 45.0;
  const Plan plan = plan_back_and_forth(site.ground, o);
  for (const double gap : gaps_between(plan.route)) EXPECT_NEAR(gap, 45.0, 1e-6);
  EXPECT_THAT(plan.notes.back(), HasSubstr("lines lie 45 m apart, as asked, and leave gaps"));
}

TEST(LineSpacing, EachRegionOfMultiDepthHasItsOwn) {
  const TestSite site(stepped(400, 200, 10, 30));
  PlanOptions o = fan_options(90.0);
  o.bands.limits = {20.0};
  o.heading = Angle::degrees(90.0);
  const Plan plan = plan_multi_depth(site.ground, o);
  ASSERT_EQ(plan.regions.regions.size(), 2U);
  std::vector<double> rows[2];
  for (const Leg& leg : legs(plan.route)) {
    const Waypoint& w = plan.route.waypoints[leg.first];
    if (w.log) rows[*w.region].push_back(w.position.y());
  }
  for (const std::size_t r : {0U, 1U}) {
    std::sort(rows[r].begin(), rows[r].end());
    ASSERT_GT(rows[r].size(), 2U);
    const bool deep = plan.regions.regions[r].mean_depth_m > 20.0;
    // The face that the step cuts belongs to one of both, so the deep one may hold shoaler water.
    const double spacing = rows[r][1] - rows[r][0];
    EXPECT_NEAR(
        spacing,
        1.8 * (deep ? depth_of(block_depths(region_outline(plan.mesh, plan.regions.regions[r]),
                                            site.depths),
                               {})
                    : 10.0),
        1e-3);
  }
}

TEST(LineSpacing, OptionsOutOfRangeAreRefused) {
  const TestSite site(flat(60, 60, 10));
  const auto refused = [&](const auto& change) {
    PlanOptions o = fan_options(120.0);
    change(o);
    EXPECT_THROW(static_cast<void>(plan_back_and_forth(site.ground, o)), UsageError);
  };
  refused([](PlanOptions& o) { o.rows.overlap = 1.0; });
  refused([](PlanOptions& o) { o.rows.overlap = -0.1; });
  refused([](PlanOptions& o) { o.rows.spacing_m = 0.0; });
  refused([](PlanOptions& o) { o.rows.spacing_m = 0.001; });  // more rows than anyone sails
  refused([](PlanOptions& o) { o.opening_angle = Angle::degrees(121.0); });
}

TEST(LineSpacing, ALaneIsWhatTheFanSweepsButNoMoreThanW) {
  const TestSite site(flat(100, 100, 8));
  PlanOptions o = fan_options(130.0);
  EXPECT_NEAR(*usual_lane_m(site.ground, o), 16.0 * std::tan(Angle::degrees(65).rad()), 1e-9);
  o.resolution_m = 0.1;
  EXPECT_NEAR(*usual_lane_m(site.ground, o), 25.6, 1e-9);
}

}  // namespace
}  // namespace swathplan

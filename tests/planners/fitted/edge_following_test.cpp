#include "planners/fitted/edge_following.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "coverage/score.h"
#include "mesh/synthetic.h"
#include "planners/fitted/line_design.h"
#include "planners/test_site.h"
#include "planners/wide_fan.h"

namespace swathplan {
namespace {

TEST(EdgeFollowing, LinesMeetTheSwathBeforeThemLessTheMargin) {
  // Off the deep edge, so that each line lies up the slope from the one before.
  const Angle slope = Angle::degrees(2.0);
  const TestSite site(tilted(1000.0, 300.0, 20.0, slope));
  const DesignGround g(site.ground, kOpening, 0.0, 3e5);
  const AreaQuery water(site.ground.water);
  const double margin = 0.08;
  const auto lines = edge_following_lines(g.swaths, water, {{1000.0, 0.0}, {1000.0, 300.0}},
                                          {.margin = margin, .smooth_passes = 10});
  ASSERT_GE(lines.size(), 5U);
  const double rise = tan(slope) * kTan;
  for (std::size_t k = 0; k + 2 < lines.size(); ++k) {
    const auto depth = [&](std::size_t i) {
      return 20.0 + lines[i].points[lines[i].points.size() / 2].x() * tan(slope);
    };
    const double apart = (depth(k) - depth(k + 1)) / tan(slope);
    const double shared =
        depth(k) * kTan / (1.0 + rise) + depth(k + 1) * kTan / (1.0 - rise) - apart;
    // To first order in the slope: a swath is as wide down the slope as up.
    EXPECT_NEAR(shared / (2.0 * depth(k + 1) * kTan), margin, 0.3 * rise + 0.01);
  }
  EXPECT_LE(judge_lines(swept(lines, g.swaths), g.swaths).missed, 1e-3);
}

// A ragged edge cuts the ends off the fronts that reach it.
TEST(EdgeFollowing, NoLineIsShorterThanTheLeast) {
  TestSite site(flat(160.0, 100.0, 6.0));
  Ring ragged{{0, 0}, {160, 0}};
  for (int tooth = 0; tooth < 10; ++tooth) {
    ragged.emplace_back(160.0 - 16.0 * tooth, 100.0);
    ragged.emplace_back(152.0 - 16.0 * tooth, 88.0);
  }
  site.ground.survey_area = {{ragged, {}}};
  site.ground.water = site.ground.survey_area;
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const auto shortest = [&](double least_m) {
    PlanOptions options;
    options.resolution_m = 0.5;
    options.least_line_m = least_m;
    const Plan plan = plan_edge_following(site.ground, options);
    const auto& w = plan.route.waypoints;
    double found = 1e9;
    for (const Leg& leg : legs(plan.route)) {
      if (w[leg.first].kind != LegKind::line) continue;
      double length = 0.0;
      for (std::size_t i = leg.first; i < leg.last; ++i) {
        length += (w[i + 1].position - w[i].position).norm();
      }
      found = std::min(found, length);
    }
    return found;
  };
  EXPECT_LT(shortest(0.0), 10.0);
  EXPECT_GE(shortest(20.0), 19.0) << "its ends may be cut for the turns";
}

TEST(EdgeFollowing, PlansConfinedWaterInsideIt) {
  TestSite site(stepped(60.0, 40.0, 6.0, 10.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions options;
  options.resolution_m = 0.25;
  const Plan plan = plan_edge_following(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  ScoreOptions how;
  how.resolution_m = options.resolution_m;
  how.footprint = false;
  const Score score =
      swathplan::score(plan.route, site.ground, options.sonar, options.vehicle, how).score;
  EXPECT_GE(score.all.hit_pct, 90.0);
  EXPECT_LE(score.route.outside_water_m, 0.01);
}

}  // namespace
}  // namespace swathplan

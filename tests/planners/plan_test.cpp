#include "planners/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "coverage/route/route_figures.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/nuc/mdnuc.h"
#include "planners/nuc/nuc.h"
#include "planners/rows/back_and_forth.h"
#include "planners/rows/multi_depth.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

testing::AssertionResult is_valid(const Route& route) {
  if (const auto wrong = fault(route)) return testing::AssertionFailure() << *wrong;
  return testing::AssertionSuccess();
}

using Planner = Plan (*)(const Ground&, const PlanOptions&);
const std::vector<std::pair<const char*, Planner>> kPlanners{
    {"back-and-forth", plan_back_and_forth},
    {"multi-depth", plan_multi_depth},
    {"nuc", plan_nuc},
    {"mdnuc", plan_mdnuc}};

TEST(Planners, EveryRouteIsValidAndStaysInTheWater) {
  for (Seafloor floor : {saddle(), shaft(), harbour()}) {
    const TestSite site(std::move(floor), kSafeDepthM);
    for (const auto& [name, plan] : kPlanners) {
      SCOPED_TRACE(name);
      const Plan result = plan(site.ground, row_options(0.10, 3));
      EXPECT_TRUE(is_valid(result.route));
      const RouteFigures figures = route_figures(result.route, {}, site.ground.water, site.depths,
                                                 area_m2(site.ground.survey_area), 25.6);
      EXPECT_LT(figures.outside_water_m, 0.01);
      EXPECT_GT(figures.min_under_keel_m, 0.0);
    }
  }
}

TEST(Planners, QuadsKeepTheRouteInTheWaterToo) {
  for (Seafloor floor : {saddle(), shaft(), harbour()}) {
    const TestSite site(std::move(floor), kSafeDepthM);
    for (const Planner plan : {plan_nuc, plan_mdnuc}) {
      PlanOptions o = row_options(0.10, 3);
      const Plan triangles = plan(site.ground, o);
      o.faces = FaceShape::quad;
      const Plan quads = plan(site.ground, o);
      EXPECT_TRUE(is_valid(quads.route));
      EXPECT_LT(quads.mesh.faces.size(), triangles.mesh.faces.size());
      const RouteFigures figures = route_figures(quads.route, {}, site.ground.water, site.depths,
                                                 area_m2(site.ground.survey_area), 25.6);
      EXPECT_LT(figures.outside_water_m, 0.01);
    }
  }
}

TEST(Planners, StartPointIsTaken) {
  const TestSite site(harbour(), kSafeDepthM);
  for (const auto& [name, plan] : kPlanners) {
    SCOPED_TRACE(name);
    PlanOptions o = row_options(0.25, 2);
    o.start = Vec2(250, 340);
    const Vec2 first = plan(site.ground, o).route.waypoints.front().position;
    EXPECT_LT((first - *o.start).norm(), 64.0) << "within W";
  }
}

TEST(Planners, OpeningFollowsTheMeanDepthBelowTheSonar) {
  const TestSite site(flat(100, 100, 20), kSafeDepthM);
  const Plan plan = plan_nuc(site.ground, row_options(0.10, 1));
  const double expected = 2.0 * std::atan2(12.8, 20.0 - 0.3);
  ASSERT_EQ(plan.openings.size(), 1U);
  EXPECT_NEAR(plan.openings[0].rad(), expected, 1e-3);
  for (const Waypoint& w : plan.route.waypoints) {
    if (w.fan) {
      EXPECT_NEAR(w.fan->port.rad(), 0.5 * expected, 1e-3);
    }
  }
}

TEST(Planners, OpeningIsCappedByTheSonar) {
  const TestSite site(flat(100, 100, 3), kSafeDepthM);
  PlanOptions o = row_options(0.25, 1);
  o.sonar.max_opening = Angle::degrees(120);
  for (const auto& [name, plan] : kPlanners) {
    SCOPED_TRACE(name);
    for (const Waypoint& w : plan(site.ground, o).route.waypoints) {
      if (w.fan) {
        EXPECT_LE((w.fan->port + w.fan->starboard).deg(), 120.0 + 1e-9);
      }
    }
  }
}

TEST(Planners, OptionsOutOfRangeAreNamed) {
  const TestSite site(flat(60, 60, 10), kSafeDepthM);
  const auto complains = [&](PlanOptions o, const char* about) {
    for (const auto& [name, plan] : kPlanners) {
      try {
        static_cast<void>(plan(site.ground, o));
        ADD_FAILURE() << name << " accepted a bad " << about;
      } catch (const UsageError& e) {
        EXPECT_NE(std::string(e.what()).find(about), std::string::npos) << e.what();
      }
    }
  };
  PlanOptions o = row_options(0.0, 1);
  complains(o, "resolution");
  o = row_options(0.1, 1);
  o.face_size = -1.0;
  complains(o, "face size");
  o = row_options(0.1, 1);
  o.sonar.max_opening = Angle::degrees(180);
  complains(o, "max opening");
  o = row_options(0.1, 1);
  o.sonar.beams = 1;
  complains(o, "beams");
}

// Two basins that nothing joins: the route says so, and counts the way over land.
TEST(Planners, SeparateWatersAreJoinedOnlyWithANote) {
  Seafloor floor = flat(100, 60, 10);
  std::erase_if(floor.faces, [&](const Seafloor::Face& f) {
    const double x = floor.vertices[f[0]].x();
    return x > 44 && x < 56;
  });
  const TestSite site(std::move(floor), kSafeDepthM);
  ASSERT_EQ(site.ground.survey_area.size(), 2U);
  for (const auto& [name, plan] : kPlanners) {
    SCOPED_TRACE(name);
    const Plan result = plan(site.ground, row_options(0.10, 1));
    EXPECT_TRUE(is_valid(result.route));
    EXPECT_FALSE(result.notes.empty());
    const RouteFigures figures =
        route_figures(result.route, {}, site.ground.water, site.depths, 1.0, 25.6);
    EXPECT_GT(figures.outside_water_m, 8.0);
  }
}

}  // namespace
}  // namespace swathplan

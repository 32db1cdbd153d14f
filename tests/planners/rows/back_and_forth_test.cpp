#include "planners/rows/back_and_forth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "coverage/tracing/ray_scene.h"
#include "mesh/synthetic.h"
#include "planners/rows/route_builder.h"
#include "planners/rows/survey_lines.h"
#include "planners/rows/wide_turns.h"
#include "planners/simulated.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

// The pit's middle rows sound little of it where they are centred: shifted they bring more for the
// same path.
TEST(BackAndForth, TheSimulatorPlacesFewRows) {
  TestSite site(shaft(), kSafeDepthM);
  const PlanOptions o = row_options(0.10, 2);
  const Plan centred = plan_back_and_forth(site.ground, o);
  EXPECT_TRUE(centred.notes.empty());
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  const Plan placed = plan_back_and_forth(site.ground, o);
  ASSERT_FALSE(placed.notes.empty());
  EXPECT_NE(placed.notes.back().find("of 9 placements"), std::string::npos) << placed.notes.back();
  const Outcome before = simulated_hits(centred.route, site.ground, o);
  const Outcome after = simulated_hits(placed.route, site.ground, o);
  EXPECT_GT(after.cover_pct, before.cover_pct + 0.5);
  EXPECT_LE(after.length_ratio, before.length_ratio + 1e-9);
}

// A bay cuts the upper row in two; rows shifted away from it are fewer, so they are not tried.
TEST(BackAndForth, TheNoteCountsThePlacementsThatWereTried) {
  TestSite site(flat(100, 60, 10));
  site.ground.survey_area = {
      {.outer = {{0, 0}, {100, 0}, {100, 60}, {55, 60}, {55, 42}, {45, 42}, {45, 60}, {0, 60}},
       .holes = {}}};
  site.ground.water = site.ground.survey_area;
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions o = row_options(0.10, 1);
  o.heading = Angle::degrees(90.0);
  const Plan plan = plan_back_and_forth(site.ground, o);
  ASSERT_FALSE(plan.notes.empty());
  EXPECT_THAT(plan.notes.back(), testing::ContainsRegex("of [1-5] placements? "));
}

TEST(BackAndForth, OpeningByPingFollowsTheDepthBelow) {
  const TestSite site(tilted(100, 60, 8, Angle::degrees(12)), kSafeDepthM);
  PlanOptions o = row_options(0.10, 1);
  o.opening = Opening::ping;
  const Plan plan = plan_back_and_forth(site.ground, o);
  const auto& w = plan.route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const double depth = site.depths.depth(0.5 * (w[i].position + w[i + 1].position)).value();
    EXPECT_NEAR(w[i].fan->port.rad(), std::atan2(12.8, depth - 0.3), 1e-6);
  }
}

/// Lines of a route in the order they are sailed: where each begins and ends.
std::vector<SurveyLine> sailed_lines(const Route& route) {
  std::vector<SurveyLine> lines;
  for (const Leg& leg : legs(route)) {
    if (!route.waypoints[leg.first].log) continue;
    lines.push_back({route.waypoints[leg.first].position, route.waypoints[leg.last].position, 0});
  }
  return lines;
}

TEST(BackAndForth, SkipsRowsWhereTurnsAreWiderThanTheSpacing) {
  const WideTurns wide;
  const Plan plan = plan_back_and_forth(wide.site.ground, wide.how);
  const auto lines = sailed_lines(plan.route);
  ASSERT_GE(lines.size(), 8U);
  std::set<long> rows;
  for (const SurveyLine& line : lines) {
    EXPECT_NEAR(line.from.y(), line.to.y(), 1e-6);
    EXPECT_NEAR(std::abs(line.to.x() - line.from.x()), 440.0, 1.0) << "no line is cut or left out";
    EXPECT_TRUE(rows.insert(std::lround(line.from.y())).second) << "a line is sailed twice";
  }
  std::size_t skips = 0;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    skips += std::abs(lines[i].from.y() - lines[i - 1].to.y()) > 1.5 * 25.6 ? 1 : 0;
  }
  EXPECT_GE(skips, lines.size() - 3);
  EXPECT_NE(plan.notes.back().find("order of the least way"), std::string::npos);

  const Connector connector = connector_for(wide.site.ground, wide.how);
  RouteBuilder builder(wide.site.ground, wide.how, connector);
  int number = 1;
  std::vector<SurveyLine> given = lines;
  std::sort(given.begin(), given.end(),
            [](const auto& a, const auto& b) { return a.from.y() < b.from.y(); });
  for (std::size_t i = 0; i < given.size(); ++i) {
    if ((given[i].to.x() > given[i].from.x()) != (i % 2 == 0))
      std::swap(given[i].from, given[i].to);
    builder.add_line(line_waypoints(given[i], number++, {}, wide.how));
  }
  EXPECT_LT(length_m(plan.route), 0.95 * length_m(builder.finish()));
}

TEST(BackAndForth, SailsToAndFroWhereTheTurnFitsBetweenRows) {
  WideTurns narrow;
  narrow.how.vehicle.turn_radius_m = 12.8;
  const Plan plan = plan_back_and_forth(narrow.site.ground, narrow.how);
  const auto lines = sailed_lines(plan.route);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_NEAR(std::abs(lines[i].from.y() - lines[i - 1].to.y()), 25.6, 1e-6);
  }
  EXPECT_TRUE(plan.notes.empty());
}

}  // namespace
}  // namespace swathplan

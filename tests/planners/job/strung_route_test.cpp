#include "planners/job/strung_route.h"

#include <gtest/gtest.h>

#include "coverage/route/route_figures.h"
#include "planners/job/job_site.h"

namespace swathplan {
namespace {

TEST(StrungRoute, LinesInTheirOrderGiveTheSameRouteAgain) {
  const JobSite bench;
  const Route route = bench.rows(5);
  const BuiltRoute built = strung(job_lines(route, bench.how.vehicle.turn_radius_m), std::nullopt,
                                  bench.site.ground, bench.how, bench.connector);
  ASSERT_EQ(built.route.waypoints.size(), route.waypoints.size());
  for (std::size_t i = 0; i < route.waypoints.size(); ++i) {
    EXPECT_LT((built.route.waypoints[i].position - route.waypoints[i].position).norm(), 1e-6);
    EXPECT_EQ(built.route.waypoints[i].kind, route.waypoints[i].kind);
  }
}

TEST(StrungRoute, BeginsAndEndsAtTheBerthWithTheSonarOff) {
  const JobSite bench;
  const Vec2 berth(300, 20);
  const BuiltRoute built = strung(job_lines(bench.rows(3), bench.how.vehicle.turn_radius_m),
                                  Berth{berth}, bench.site.ground, bench.how, bench.connector);
  EXPECT_FALSE(fault(built.route)) << *fault(built.route);
  const auto& w = built.route.waypoints;
  EXPECT_EQ(w.front().position, berth);
  EXPECT_EQ(w.back().position, berth);
  EXPECT_EQ(w.front().kind, LegKind::transit);
  EXPECT_FALSE(w.front().fan);
  EXPECT_FALSE(w[w.size() - 2].fan);
  EXPECT_EQ(infeasible_m(built.route), 0.0);
  const RouteFigures figures = route_figures(built.route, bench.how.vehicle,
                                             bench.site.ground.water, bench.site.depths, 1.0, 1.0);
  EXPECT_LT(figures.outside_water_m, 1e-3);
  EXPECT_LT(figures.tight_turn_m, 1e-3);
}

TEST(StrungRoute, TheNextSortieLeavesOnTheCourseOfArrivalSoThatTheWholeCanBeSteered) {
  const JobSite bench;
  const Vec2 berth(300, 20);
  const std::vector<JobLine> lines = job_lines(bench.rows(4), bench.how.vehicle.turn_radius_m);
  const BuiltRoute one =
      strung({lines[0], lines[1]}, Berth{berth}, bench.site.ground, bench.how, bench.connector);
  const BuiltRoute two = strung({lines[2], lines[3]}, end_of(one.route), bench.site.ground,
                                bench.how, bench.connector);
  const Route all = one_after_the_other({&one.route, &two.route});
  EXPECT_FALSE(fault(all)) << *fault(all);
  EXPECT_NEAR(length_m(all), length_m(one.route) + length_m(two.route), 1e-6);
  const RouteFigures figures =
      route_figures(all, bench.how.vehicle, bench.site.ground.water, bench.site.depths, 1.0, 1.0);
  EXPECT_LT(figures.tight_turn_m, 0.05);
}

TEST(StrungRoute, PiecesOfALineInOneSortieAreTheLineAgain) {
  const JobSite bench;
  const JobLine line = bench.northward(100, 1);
  const BuiltRoute built =
      strung(divided(line, 4), std::nullopt, bench.site.ground, bench.how, bench.connector);
  EXPECT_NEAR(length_m(built.route), 200.0, 1e-9);
}

TEST(StrungRoute, NoLinesGiveAnEmptyRoute) {
  const JobSite bench;
  EXPECT_TRUE(strung({}, Berth{Vec2(300, 20)}, bench.site.ground, bench.how, bench.connector)
                  .route.waypoints.empty());
}

}  // namespace
}  // namespace swathplan

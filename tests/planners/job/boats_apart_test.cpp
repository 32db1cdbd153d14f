#include "planners/job/boats_apart.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

Route alone(const JobLine& line) {
  Route route{line.points};
  route.waypoints.back().kind = LegKind::end;
  route.waypoints.back().log = false;
  route.waypoints.back().line.reset();
  return route;
}

TEST(BoatsApart, ParallelLinesAreNeighboursWhereTheirSwathsTouch) {
  const JobSite bench;
  const double below = 20.0 - bench.how.vehicle.draft_m;
  const double swath = below * (tan(bench.fan.port) + tan(bench.fan.starboard));
  EXPECT_NEAR(swath_of(bench.northward(100, 1).points, bench.site.ground, bench.how.vehicle), swath,
              1e-6);
  const JobLine line = bench.northward(100, 1);
  EXPECT_TRUE(neighbours(line, bench.northward(100 + 0.9 * swath, 2), swath));
  EXPECT_FALSE(neighbours(line, bench.northward(100 + 1.1 * swath, 2), swath));
  JobLine cross = line;
  for (Waypoint& w : cross.points) w.kind = LegKind::cross;
  EXPECT_FALSE(neighbours(line, cross, swath));
}

TEST(BoatsApart, CountsTheSecondsOnNeighbouringLinesAndTheLeastDistance) {
  const JobSite bench;
  const Route one = alone(bench.northward(100, 1));
  const Route other = alone(bench.northward(120, 2));
  // 200 m at 2 m/s: 100 s each. The second boat begins 40 s later and stays 80 m behind.
  const BoatsApart apart =
      boats_apart({{{0.0, &one}}, {{40.0, &other}}}, bench.site.ground, bench.how.vehicle);
  EXPECT_NEAR(apart.neighbours_s, 60.0, 1e-6);
  ASSERT_TRUE(apart.least_m);
  EXPECT_NEAR(*apart.least_m, std::hypot(20.0, 80.0), 1e-6);
  const BoatsApart later =
      boats_apart({{{0.0, &one}}, {{101.0, &other}}}, bench.site.ground, bench.how.vehicle);
  EXPECT_EQ(later.neighbours_s, 0.0);
  EXPECT_FALSE(later.least_m);
}

TEST(BoatsApart, BoatsThatMeetHeadOnPassAtTheDistanceOfTheirLines) {
  const JobSite bench;
  const Route one = alone(bench.northward(100, 1));
  const Route other = alone(backwards(bench.northward(115, 2)));
  const BoatsApart apart =
      boats_apart({{{0.0, &one}}, {{0.0, &other}}}, bench.site.ground, bench.how.vehicle);
  EXPECT_NEAR(*apart.least_m, 15.0, 1e-6);
  // Within a swath of each other they sail towards and past each other at 4 m/s.
  const double swath =
      (20.0 - bench.how.vehicle.draft_m) * (tan(bench.fan.port) + tan(bench.fan.starboard));
  const double seconds = 2.0 * std::sqrt(swath * swath - 15.0 * 15.0) / 4.0;
  EXPECT_NEAR(apart.within_a_swath_s, seconds, 1e-6);
}

TEST(BoatsApart, OrdersAreTurnedSoThatNeighboursComeAtDifferentTimes) {
  const JobSite bench;
  // The first boat ends where the second one ends: both at the seam at the same time.
  SortieLines one, other;
  for (const double x : {50.0, 100.0, 150.0, 200.0}) one.push_back(bench.northward(x, 1));
  for (const double x : {360.0, 320.0, 280.0, 220.0}) other.push_back(bench.northward(x, 2));
  const Vec2 quay(200, 20);
  const auto kept =
      kept_apart({one, other}, 0, bench.site.ground, bench.how.vehicle, bench.ways, quay);
  ASSERT_EQ(kept.size(), 2U);
  std::vector<Route> routes;
  for (const SortieLines& part : kept) {
    RouteBuilder builder(bench.site.ground, bench.how, bench.connector);
    for (const JobLine& line : part) builder.append(line.points);
    routes.push_back(builder.finish());
  }
  EXPECT_EQ(
      boats_apart({{{0.0, &routes[0]}}, {{0.0, &routes[1]}}}, bench.site.ground, bench.how.vehicle)
          .neighbours_s,
      0.0);
}

}  // namespace
}  // namespace swathplan

#include "io/exports/geographic_route.h"

#include <gtest/gtest.h>

#include "io/files/lonlat.h"
#include "io/sample_plan.h"
#include "io/sample_route.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

Frame frame_in(const char* crs, const Vec2& origin) {
  return {.origin = origin, .metres_per_unit = 1.0, .crs_wkt = parse_crs(crs)};
}

Route straight(const Vec2& from, const Vec2& to) {
  Route route;
  route.waypoints.resize(2);
  route.waypoints[0].position = from;
  route.waypoints[1].position = to;
  route.waypoints[1].kind = LegKind::end;
  return route;
}

/// The path that a boat sails which keeps straight in longitude and latitude, in local metres.
std::vector<Vec2> sailed(const GeographicRoute& route, const Frame& frame) {
  std::vector<Vec2> points;
  for (std::size_t i = 1; i < route.lonlat.size(); ++i) {
    Vec2 step = route.lonlat[i] - route.lonlat[i - 1];
    step.x() = std::remainder(step.x(), 360.0);
    for (int k = 0; k < 4; ++k) points.emplace_back(route.lonlat[i - 1] + 0.25 * k * step);
  }
  points.push_back(route.lonlat.back());
  return LonLat(frame).to_local(points);
}

TEST(GeographicRoute, StaysWithinTheToleranceAndSaysHowFar) {
  const Frame frame = test::utm_frame();
  const Route route = test::lawnmower(2);
  for (const double tolerance : {0.01, 0.1, 1.0}) {
    const GeographicRoute thinned = geographic_route(route, frame, tolerance);
    ASSERT_EQ(thinned.lonlat.size(), thinned.route.waypoints.size());
    EXPECT_LE(thinned.largest_distance_m, tolerance);
    EXPECT_LT(thinned.lonlat.size(), route.waypoints.size() / 5);
    EXPECT_LE(test::largest_distance(route, sailed(thinned, frame)),
              thinned.largest_distance_m + 1e-4);
    EXPECT_EQ(legs(thinned.route).size(), legs(route).size());
  }
}

TEST(GeographicRoute, LongLinesAreDividedSinceParallelsBend) {
  // 20 km eastwards at 60 degrees north: the parallel stands off from the straight by 14 m.
  const Frame frame = frame_in("EPSG:32633", Vec2(490000, 6650000));
  const Route route = straight(Vec2(0, 0), Vec2(20000, 0));
  const GeographicRoute divided = geographic_route(route, frame, 0.1);
  EXPECT_GT(divided.lonlat.size(), 10U);
  EXPECT_LT(divided.lonlat.size(), 100U);
  EXPECT_LE(divided.largest_distance_m, 0.1);
  for (const Vec2& p : sailed(divided, frame)) {
    EXPECT_LE(std::abs(p.y()), divided.largest_distance_m + 1e-6);
  }
  EXPECT_EQ(geographic_route(straight(Vec2(0, 0), Vec2(300, 0)), frame, 0.1).lonlat.size(), 2U);
}

TEST(GeographicRoute, CrossesTheAntimeridian) {
  const Frame frame = frame_in("EPSG:32660", Vec2(833978, 0));
  const Route route = straight(Vec2(-4000, 6000), Vec2(4000, 1000));
  const GeographicRoute divided = geographic_route(route, frame, 0.1);
  EXPECT_GT(divided.lonlat.front().x(), 179.0);
  EXPECT_LT(divided.lonlat.back().x(), -179.0);
  EXPECT_LT(divided.lonlat.size(), 10U);
  EXPECT_LE(divided.largest_distance_m, 0.1);
  EXPECT_LE(test::largest_distance(route, sailed(divided, frame)), 0.1);
}

TEST(GeographicRoute, IsRefusedWithoutACrs) {
  EXPECT_THROW((void)geographic_route(test::lawnmower(2), Frame{}, 0.1), InvalidInput);
}

}  // namespace
}  // namespace swathplan

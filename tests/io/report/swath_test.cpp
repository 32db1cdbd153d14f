#include <gtest/gtest.h>

#include <cmath>

#include "io/report/swath_internal.h"
#include "io/sample_plan.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

const Angle kSide = Angle::degrees(60.0);

Waypoint waypoint(const Vec2& position, const std::optional<FanAngles>& fan, double speed_mps) {
  Waypoint w;
  w.position = position;
  w.fan = fan;
  w.log = fan.has_value();
  w.speed_mps = speed_mps;
  return w;
}

TEST(SwathEdge, FollowsTheClosedFormsOfFlatAndTiltedFloors) {
  const Seafloor level = flat(400.0, 400.0, 20.0);
  const DepthQuery depths(level);
  const Vec2 middle = 0.5 * (depths.extent().min + depths.extent().max);
  const auto edge = internal::swath_edge(depths, {}, 1.0, middle, Vec2::UnitX(), kSide);
  EXPECT_NEAR(edge.across_m, 19.0 * std::sqrt(3.0), 1e-2);
  EXPECT_NEAR(edge.range_m, 38.0, 1e-2);

  const Seafloor ramp = tilted(400.0, 400.0, 5.0, Angle::degrees(10.0));
  const DepthQuery below(ramp);
  const Vec2 at = 0.5 * (below.extent().min + below.extent().max);
  // The synthetic floor's heights are rounded to millimetres.
  const double here = *below.depth(at);
  const double slope = (*below.depth(at + Vec2(50.0, 0.0)) - here) / 50.0;
  EXPECT_NEAR(slope, std::tan(Angle::degrees(10.0).rad()), 1e-4);
  const double t = std::tan(kSide.rad());
  EXPECT_NEAR(internal::swath_edge(below, {}, 0.0, at, Vec2(-1.0, 0.0), kSide).across_m,
              here * t / (1.0 + slope * t), 0.02);
  EXPECT_NEAR(
      internal::swath_edge(below, {}, 0.0, at, Vec2(1.0, 0.0), Angle::degrees(45.0)).across_m,
      here / (1.0 - slope), 0.02);
}

TEST(SwathEdge, EndsAtTheDataAndAtTheSonarsReach) {
  const Seafloor level = flat(100.0, 100.0, 20.0);
  const DepthQuery depths(level);
  const Box2& box = depths.extent();
  const Vec2 near_edge(box.max.x() - 10.0, 0.5 * (box.min.y() + box.max.y()));
  EXPECT_NEAR(internal::swath_edge(depths, {}, 0.0, near_edge, Vec2::UnitX(), kSide).across_m, 10.0,
              1.5);
  Sonar short_sighted;
  short_sighted.max_range_m = 25.0;
  EXPECT_NEAR(
      internal::swath_edge(depths, short_sighted, 0.0, near_edge, -Vec2::UnitX(), kSide).across_m,
      25.0 * std::sin(kSide.rad()), 1e-6);
  const Vec2 outside(box.max.x() + 10.0, 0.0);
  EXPECT_EQ(internal::swath_edge(depths, {}, 0.0, outside, Vec2::UnitX(), kSide).across_m, 0.0);
}

TEST(SwathOutline, IsTheStripOfALine) {
  const Seafloor level = flat(400.0, 400.0, 20.0);
  const DepthQuery depths(level);
  const Vec2 middle = 0.5 * (depths.extent().min + depths.extent().max);
  Route route;
  route.waypoints = {waypoint(middle, FanAngles{kSide, Angle::degrees(45.0)}, 2.0),
                     waypoint(middle + Vec2(0.0, 100.0), {}, 2.0)};
  const Ring ring = internal::swath_outline(route, {0, 1}, depths, {}, 0.0, 10.0);
  EXPECT_NEAR(std::abs(signed_area(ring)), 100.0 * 20.0 * (std::sqrt(3.0) + 1.0), 2.0);
  EXPECT_NEAR(ring.front().x(), middle.x() - 20.0 * std::sqrt(3.0), 1e-2);  // port, sailing north
  EXPECT_NEAR(ring.back().x(), middle.x() + 20.0, 1e-2);
}

TEST(AlongTrack, GivesDepthAndPingSpacingByTheClock) {
  const Seafloor level = flat(400.0, 400.0, 20.0);
  const DepthQuery depths(level);
  const Vec2 middle = 0.5 * (depths.extent().min + depths.extent().max);
  Route route;
  route.waypoints = {waypoint(middle, FanAngles{kSide, kSide}, 4.0),
                     waypoint(middle + Vec2(0.0, 100.0), {}, 2.0),
                     waypoint(middle + Vec2(0.0, 120.0), {}, 2.0)};
  PingTiming clock;
  clock.spacing_m = std::nullopt;
  const auto track = internal::along_track(route, depths, {}, 0.0, clock, 35);
  ASSERT_GE(track.size(), 35U);
  EXPECT_NEAR(track.back().seconds, 35.0, 1.0);
  EXPECT_NEAR(*track.front().depth_m, 20.0, 1e-6);
  // The farthest sounding lies 40 m off: 2 x 40 m / (0.9 x 1500 m/s) at 4 m/s.
  EXPECT_NEAR(*track.front().ping_spacing_m, 4.0 * 80.0 / 1350.0, 1e-3);
  EXPECT_FALSE(track.back().ping_spacing_m);  // sonar off
  clock.spacing_m = 0.25;
  EXPECT_EQ(internal::along_track(route, depths, {}, 0.0, clock, 35).front().ping_spacing_m, 0.25);
}

}  // namespace
}  // namespace swathplan

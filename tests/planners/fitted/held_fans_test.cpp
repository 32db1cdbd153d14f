#include "planners/fitted/held_fans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

struct Held {
  Held() : site(flat(200.0, 100.0, 30.0)), raster(site.ground), area(site.ground.survey_area) {
    options.pings.spacing_m.reset();
    options.angles = Angles::line;
    options.resolution_m = 1.0;
    options.vehicle.speed_mps = 4.0;
    options.least_speed_mps = 1.0;
    for (int i = 0; i < 20; ++i) {
      Waypoint w;
      w.position = Vec2(-20.0 + 10.0 * i, 50.0);
      // Beyond the area's edge the fan says nothing.
      const double deg = w.position.x() < 0.0 ? 3.0 : 41.3;
      w.fan = FanAngles{Angle::degrees(deg), Angle::degrees(deg / 2.0)};
      w.line = 1;
      lines[0].push_back(w);
    }
  }
  TestSite site;
  WaterRaster raster;
  AreaQuery area;
  PlanOptions options;
  std::vector<std::vector<Waypoint>> lines{1};
};

TEST(HeldFans, ALineKeepsOneFanInWholeDegrees) {
  Held held;
  hold_fans(held.lines, held.raster, held.area, held.options);
  for (const Waypoint& w : held.lines[0]) {
    ASSERT_TRUE(w.fan);
    EXPECT_NEAR(w.fan->port.deg(), 42.0, 1e-9);
    EXPECT_NEAR(w.fan->starboard.deg(), 21.0, 1e-9);
    EXPECT_EQ(w.speed_mps, held.lines[0].front().speed_mps);
  }
}

TEST(HeldFans, TheSpeedLaysTheSoundingsWanted) {
  Held held;
  held.options.soundings = 20.0;
  hold_fans(held.lines, held.raster, held.area, held.options);
  const double speed = held.lines[0].front().speed_mps;
  const double below = 30.0 - held.options.vehicle.draft_m;
  const double cosine = std::cos(Angle::degrees(42).rad());
  const double beams =
      Angle::degrees(63).rad() * below / ((held.options.sonar.beams - 1) * cosine * cosine);
  const double pings =
      speed * ping_interval_s(held.options.sonar, held.options.pings, below / cosine);
  EXPECT_GE(1.0 / (beams * pings), 20.0);
  EXPECT_LT(speed, held.options.vehicle.speed_mps);
  EXPECT_NEAR(speed * 10.0, std::round(speed * 10.0), 1e-9);
}

TEST(HeldFans, TheEdgeMayLeaveSoundingsToTheNeighbour) {
  // Half of 40 soundings asks for the speed that all of 20 does.
  Held alone, shared;
  alone.options.soundings = 20.0;
  shared.options.soundings = 40.0;
  hold_fans(alone.lines, alone.raster, alone.area, alone.options);
  hold_fans(shared.lines, shared.raster, shared.area, shared.options, 0.5);
  EXPECT_EQ(shared.lines[0].front().speed_mps, alone.lines[0].front().speed_mps);
  EXPECT_LT(alone.lines[0].front().speed_mps, alone.options.vehicle.speed_mps);
}

TEST(HeldFans, ALongLineOverOtherDepthsIsSailedInLegs) {
  // One half asks for 20 degrees, the other for 60: the wide fan would take the deep half's
  // soundings.
  const TestSite site(flat(4000.0, 100.0, 60.0));
  const WaterRaster raster(site.ground);
  const AreaQuery area(site.ground.survey_area);
  Held held;
  held.options.vehicle.speed_mps = 4.0;
  held.options.least_line_m = 100.0;
  std::vector<Waypoint> line;
  for (int i = 0; i <= 398; ++i) {
    Waypoint w;
    w.position = Vec2(10.0 + 10.0 * i, 50.0);
    const Angle side = Angle::degrees(i < 199 ? 20.0 : 60.0);
    w.fan = FanAngles{side, side};
    line.push_back(w);
  }
  std::vector<std::vector<Waypoint>> lines{line, {line.begin(), line.begin() + 20}};
  hold_fans(lines, raster, area, held.options);
  std::vector<std::size_t> changes;
  for (std::size_t i = 1; i < lines[0].size(); ++i) {
    if (lines[0][i].fan != lines[0][i - 1].fan) changes.push_back(i);
  }
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NEAR(static_cast<double>(changes[0]), 199.0, 10.0);
  EXPECT_NEAR(lines[0].back().fan->port.deg(), 60.0, 1e-9);
  // A short line is not worth a change.
  for (const Waypoint& w : lines[1]) EXPECT_EQ(w.fan, lines[1].front().fan);
}

TEST(HeldFans, ByPingOnlyWaypointsBeyondTheAreaTakeTheNearestFanInIt) {
  Held held;
  held.options.angles = Angles::ping;
  hold_fans(held.lines, held.raster, held.area, held.options);
  for (const Waypoint& w : held.lines[0]) EXPECT_NEAR(w.fan->port.deg(), 41.3, 1e-9);
}

}  // namespace
}  // namespace swathplan

#include "planners/fronts/swept_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/synthetic.h"
#include "planners/fitted/line_design.h"
#include "planners/test_site.h"
#include "planners/wide_fan.h"

namespace swathplan {
namespace {

TEST(SweptGround, ReachesFartherDownASlopeThanUp) {
  const Angle slope = Angle::degrees(3.0);
  const TestSite site(tilted(600.0, 200.0, 20.0, slope));
  const DesignGround g(site.ground, kOpening, 0.5, 2e5);
  const Vec2 p(250.0, 100.0);
  const double below = 20.0 + 250.0 * tan(slope) - 0.5;
  const double rise = tan(slope) * kTan;
  // Heights are on a millimetre lattice, and the beam's end is linear between two samples.
  EXPECT_NEAR(g.swaths.below_m(p), below, 0.01);
  EXPECT_NEAR(g.swaths.reach_m(p, {1.0, 0.0}), below * kTan / (1.0 - rise), 0.05);
  EXPECT_NEAR(g.swaths.reach_m(p, {-1.0, 0.0}), below * kTan / (1.0 + rise), 0.05);
  EXPECT_NEAR(g.swaths.reach_m(p, {0.0, 1.0}), below * kTan, 0.05);
}

TEST(SweptGround, EndsAtTheAreasEdge) {
  const TestSite site(flat(100.0, 60.0, 40.0));
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  EXPECT_NEAR(g.swaths.reach_m({10.0, 30.0}, {-1.0, 0.0}), 10.0, 1.0);
}

TEST(SweptLines, OfOneLineOnEvenGroundAreAStrip) {
  const TestSite site(flat(400.0, 200.0, 20.0));
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  const auto lines = swept(std::vector{straight_curve({0.0, 100.0}, {400.0, 100.0})}, g.swaths);
  const LinesFigures f = judge_lines(lines, g.swaths);
  const double w = 2.0 * 20.0 * kTan;
  EXPECT_NEAR(1.0 - f.missed, w / 200.0, 0.01);
  // The raster holds whole cells: it may lack a part of one along two edges.
  EXPECT_NEAR(f.least_m, 400.0 * 200.0 / w, 0.005 * f.least_m);
  EXPECT_DOUBLE_EQ(f.length_m, 400.0);
  EXPECT_EQ(f.overlap, 0.0);
  const auto twice = swept(
      {straight_curve({0.0, 100.0}, {400.0, 100.0}), straight_curve({0.0, 100.0}, {400.0, 100.0})},
      g.swaths);
  EXPECT_NEAR(judge_lines(twice, g.swaths).overlap, 1.0, 1e-12);
}

TEST(TrimEnds, CutsWhatBringsNothingAndNoMore) {
  const TestSite site(flat(400.0, 200.0, 20.0));
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  // The second line repeats the first and goes on for 100 m.
  auto lines = swept({straight_curve({0.0, 100.0}, {300.0, 100.0}),
                      straight_curve({100.0, 100.0}, {400.0, 100.0})},
                     g.swaths);
  const double missed = judge_lines(lines, g.swaths).missed;
  trim_ends(lines, g.swaths, 0.0);
  const LinesFigures f = judge_lines(lines, g.swaths);
  EXPECT_NEAR(f.missed, missed, 1e-12);
  EXPECT_NEAR(f.length_m, 400.0, 2.0);
  // A line that costs more than it brings goes whole.
  trim_ends(lines, g.swaths, 1.1);
  EXPECT_TRUE(lines.empty());
}

TEST(CarriedOn, RunsStraightOnAsFarAsTheWater) {
  const TestSite site(flat(400.0, 200.0, 20.0), 0.0, 10.0);
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  const AreaQuery water(site.ground.water);
  const SurveyCurve line =
      carried_on(straight_curve({100.0, 100.0}, {395.0, 100.0}), 0.5, g.swaths, water);
  const double half = 20.0 * kTan;
  EXPECT_NEAR(line.points.front().x(), 100.0 - half, 0.01);
  EXPECT_NEAR(line.points.back().x(), 410.0, 0.01);
}

}  // namespace
}  // namespace swathplan

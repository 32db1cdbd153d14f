#include "planners/fronts/closing_passes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/synthetic.h"
#include "planners/fitted/line_design.h"
#include "planners/test_site.h"
#include "planners/wide_fan.h"

namespace swathplan {
namespace {

TEST(ClosingPasses, CrossAGapItsShortWay) {
  const TestSite site(flat(600.0, 300.0, 30.0));
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  const double w = 2.0 * 30.0 * kTan;
  // Three rows that meet, the middle one broken for 40 m: a gap of 40 m by W.
  auto lines = swept(
      {straight_curve({0.0, 150.0 - 0.99 * w}, {600.0, 150.0 - 0.99 * w}),
       straight_curve({0.0, 150.0}, {280.0, 150.0}), straight_curve({320.0, 150.0}, {600.0, 150.0}),
       straight_curve({0.0, 150.0 + 0.99 * w}, {600.0, 150.0 + 0.99 * w})},
      g.swaths);
  const AreaQuery water(site.ground.water);
  const double before = judge_lines(lines, g.swaths).length_m;
  EXPECT_GE(judge_lines(lines, g.swaths).missed, 0.8 * 40.0 * w / (600.0 * 300.0));
  EXPECT_GE(add_closing_passes(lines, g.swaths, water, 1e-3), 1U);
  const LinesFigures f = judge_lines(lines, g.swaths);
  EXPECT_LE(f.missed, 1e-3);
  EXPECT_LE(f.length_m - before, 60.0);
  EXPECT_EQ(add_closing_passes(lines, g.swaths, water, 1e-3), 0U);
}

}  // namespace
}  // namespace swathplan

#include "planners/fitted/line_design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/base/error.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/ends_after.h"
#include "planners/test_site.h"
#include "planners/wide_fan.h"

namespace swathplan {
namespace {

constexpr double kMile = 1852.0;

/// 2 x 4 nautical miles, 110 m deep in the middle, 1.5 degrees along the long side.
struct Rectangle {
  const Angle slope = Angle::degrees(1.5);
  const double rise = tan(slope) * kTan;
  const double shoalest = 110.0 - 2.0 * kMile * tan(slope);
  const double deepest = 110.0 + 2.0 * kMile * tan(slope);
  const TestSite site{tilted(4.0 * kMile, 2.0 * kMile, shoalest, slope)};
  const DesignGround search{site.ground, kOpening, 0.0, 7e4};
  const DesignGround judge{site.ground, kOpening, 0.0, 2.8e5};

  /// Depths below the lines, deepest first.
  [[nodiscard]] std::vector<double> depths(const DesignedLines& d) const {
    std::vector<double> list;
    for (const SweptLine& line : d.lines) {
      const double x = line.points[line.points.size() / 2].x();
      for (const Vec2& p : line.points) EXPECT_NEAR(p.x(), x, 3.0) << "not along the contours";
      list.push_back(shoalest + x * tan(slope));
    }
    std::sort(list.begin(), list.end(), std::greater<>());
    return list;
  }
};

TEST(LineDesign, SlopingRectangleTakes34LinesOf2Miles) {
  const Rectangle r;
  for (const LineMethod method : {LineMethod::straight, LineMethod::edge_following}) {
    const DesignedLines d =
        design_lines(r.site.ground, r.search, r.judge, {.method = method, .overlap = 0.1});
    EXPECT_EQ(d.figures.lines, 34U) << d.what;
    EXPECT_NEAR(d.figures.length_m / kMile, 68.0, 0.2);
    EXPECT_EQ(d.figures.missed, 0.0);
  }
}

TEST(LineDesign, RowsOnTheSlopingRectangleShareATenthAsTheClosedFormSays) {
  const Rectangle r;
  const DesignedLines d = design_lines(r.site.ground, r.search, r.judge,
                                       {.method = LineMethod::straight, .overlap = 0.1});
  const std::vector<double> depth = r.depths(d);
  ASSERT_EQ(depth.size(), 34U);
  // Over depth D a line sweeps D t / (1 - s t) down the slope and D t / (1 + s t) up it, with s the
  // slope and t the tangent of half the opening; s metres across is a metre of depth.
  const double down = kTan / (1.0 - r.rise);
  const double up = kTan / (1.0 + r.rise);
  for (std::size_t k = 0; k + 1 < depth.size(); ++k) {
    const double apart = (depth[k] - depth[k + 1]) / tan(r.slope);
    const double shared = depth[k] * up + depth[k + 1] * down - apart;
    EXPECT_GE(shared, 0.1 * depth[k] * (up + down)) << "of the wider swath, at line " << k;
  }
  // The outermost swaths reach the edges, to the fineness of the raster.
  EXPECT_GE(depth.front() / (1.0 - r.rise), r.deepest - r.judge.raster.cell_m() * tan(r.slope));
  EXPECT_LE(depth.back() / (1.0 + r.rise), r.shoalest + r.judge.raster.cell_m() * tan(r.slope));
}

TEST(LineDesign, FewerThan34LinesCannotDoIt) {
  // The recursion, free of the program: each line as far up the slope as sharing a tenth of the
  // narrower swath lets it lie.
  const Rectangle r;
  const double down = kTan / (1.0 - r.rise);
  const double up = kTan / (1.0 + r.rise);
  const double per_metre = 1.0 / tan(r.slope);
  double depth = r.deepest * (1.0 - r.rise);
  int lines = 1;
  while (depth / (1.0 + r.rise) > r.shoalest) {
    depth *= (per_metre - up) / (per_metre + down - 0.1 * (up + down));
    ++lines;
  }
  EXPECT_EQ(lines, 34);
}

TEST(LineDesign, FieldLinesInTheSeaComeWithinThreePerCentOfTheBound) {
  const TestSite site(sea(), 0.0, 200.0);
  const DesignGround search(site.ground, kOpening, 0.0, 6e4);
  const DesignGround judge(site.ground, kOpening, 0.0, 3e5);
  const DesignedLines d = design_lines(site.ground, search, judge, {.method = LineMethod::field});
  EXPECT_LE(d.figures.ratio(), 1.03) << d.what;
  EXPECT_LE(d.figures.missed, 5e-4);
  EXPECT_GT(d.figures.ratio(), 1.0 - d.figures.missed);
  const Route route = route_of(d, site.ground.water, kOpening, Vehicle{});
  EXPECT_EQ(fault(route), std::nullopt);
}

DesignedLines two_lines() {
  DesignedLines designed;
  for (const double x : {20.0, 80.0}) {
    SweptLine line;
    for (int y = 10; y <= 50; ++y) line.points.emplace_back(x, y);
    designed.lines.push_back(line);
  }
  return designed;
}

TEST(LineDesign, TransitsLeadAroundLandAndNoGo) {
  const Ring island{{40, 5}, {40, 95}, {60, 95}, {60, 5}};
  const Area water{{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {island}}};
  const Route route = route_of(two_lines(), water, kOpening, Vehicle{});
  ASSERT_EQ(fault(route), std::nullopt);
  const AreaQuery safe(water);
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const double length = (w[i + 1].position - w[i].position).norm();
    EXPECT_NEAR(safe.inside_length(w[i].position, w[i + 1].position), length, 1e-6) << i;
    EXPECT_TRUE(w[i].feasible);
  }
}

TEST(LineDesign, TransitsWithoutAWayAreMarked) {
  const Area basins{{{{0, 0}, {40, 0}, {40, 100}, {0, 100}}, {}},
                    {{{60, 0}, {100, 0}, {100, 100}, {60, 100}}, {}}};
  const Route route = route_of(two_lines(), basins, kOpening, Vehicle{});
  ASSERT_EQ(fault(route), std::nullopt);
  const auto marked = std::count_if(route.waypoints.begin(), route.waypoints.end(),
                                    [](const Waypoint& w) { return !w.feasible; });
  EXPECT_EQ(marked, 1);
}

TEST(LineDesign, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(check({.overlap = 0.5}), UsageError);
  EXPECT_THROW(check({.most_missed = 0.0}), UsageError);
  EXPECT_NO_THROW(check(LineDesignOptions{}));
}

TEST(LineDesign, ASearchThatIsEndedKeepsTheBestLinesTriedByThen) {
  const Rectangle r;
  test::EndsAfter watcher(2);
  LineDesignOptions options;
  options.watch = Watch(watcher);
  const DesignedLines d = design_lines(r.site.ground, r.search, r.judge, options);
  EXPECT_EQ(watcher.count, 2U);
  EXPECT_TRUE(d.ended_early);
  EXPECT_GT(d.figures.lines, 10U);
  EXPECT_LT(d.figures.missed, 0.01);
}

}  // namespace
}  // namespace swathplan

#include "planners/fitted/line_design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coverage/score.h"
#include "mesh/base/error.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/fitted/edge_following.h"
#include "planners/fronts/closing_passes.h"

namespace swathplan {
namespace {

constexpr double kMile = 1852.0;
const Angle kOpening = Angle::degrees(120.0);
const double kTan = std::sqrt(3.0);  // of half the opening

struct Site {
  explicit Site(Seafloor floor, double run_out_m = 0.0)
      : seafloor(std::move(floor)), depths(seafloor) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.survey_area = survey_area(seafloor, {});
    ground.water = run_out_m > 0.0 ? offset(ground.survey_area, run_out_m) : ground.survey_area;
  }
  Seafloor seafloor;
  DepthQuery depths;
  PlanningGround ground;
};

TEST(SweptGround, ReachesFartherDownASlopeThanUp) {
  const Angle slope = Angle::degrees(3.0);
  const Site site(tilted(600.0, 200.0, 20.0, slope));
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
  const Site site(flat(100.0, 60.0, 40.0));
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  EXPECT_NEAR(g.swaths.reach_m({10.0, 30.0}, {-1.0, 0.0}), 10.0, 1.0);
}

TEST(SweptLines, OfOneLineOnEvenGroundAreAStrip) {
  const Site site(flat(400.0, 200.0, 20.0));
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
  const Site site(flat(400.0, 200.0, 20.0));
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
  const Site site(flat(400.0, 200.0, 20.0), 10.0);
  const DesignGround g(site.ground, kOpening, 0.0, 2e5);
  const AreaQuery water(site.ground.water);
  const SurveyCurve line =
      carried_on(straight_curve({100.0, 100.0}, {395.0, 100.0}), 0.5, g.swaths, water);
  const double half = 20.0 * kTan;
  EXPECT_NEAR(line.points.front().x(), 100.0 - half, 0.01);
  EXPECT_NEAR(line.points.back().x(), 410.0, 0.01);
}

TEST(CutTo, GivesThePartsInside) {
  const AreaQuery area({{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}},
                         {{{4.0, 2.0}, {4.0, 8.0}, {6.0, 8.0}, {6.0, 2.0}}}}});
  const auto parts = cut_to(straight_curve({-3.0, 5.0}, {13.0, 5.0}), area);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].points.front().x(), 0.0, 1e-3);
  EXPECT_NEAR(parts[0].points.back().x(), 4.0, 1e-3);
  EXPECT_NEAR(length_m(parts[1]), 4.0, 2e-3);
  EXPECT_TRUE(cut_to(straight_curve({-3.0, 11.0}, {13.0, 11.0}), area).empty());
}

TEST(ClosingPasses, CrossAGapItsShortWay) {
  const Site site(flat(600.0, 300.0, 30.0));
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

/// 2 x 4 nautical miles, 110 m deep in the middle, 1.5 degrees along the long side.
struct Rectangle {
  const Angle slope = Angle::degrees(1.5);
  const double rise = tan(slope) * kTan;
  const double shoalest = 110.0 - 2.0 * kMile * tan(slope);
  const double deepest = 110.0 + 2.0 * kMile * tan(slope);
  const Site site{tilted(4.0 * kMile, 2.0 * kMile, shoalest, slope)};
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
  const Site site(sea(), 200.0);
  const DesignGround search(site.ground, kOpening, 0.0, 6e4);
  const DesignGround judge(site.ground, kOpening, 0.0, 3e5);
  const DesignedLines d = design_lines(site.ground, search, judge, {.method = LineMethod::field});
  EXPECT_LE(d.figures.ratio(), 1.03) << d.what;
  EXPECT_LE(d.figures.missed, 5e-4);
  EXPECT_GT(d.figures.ratio(), 1.0 - d.figures.missed);
  const Route route = route_of(d, site.ground.water, kOpening, Vehicle{});
  EXPECT_EQ(fault(route), std::nullopt);
}

TEST(LineDesign, OptionsOutOfRangeAreRefused) {
  EXPECT_THROW(check({.overlap = 0.5}), UsageError);
  EXPECT_THROW(check({.most_missed = 0.0}), UsageError);
  EXPECT_NO_THROW(check(LineDesignOptions{}));
}

TEST(EdgeFollowing, LinesMeetTheSwathBeforeThemLessTheMargin) {
  // Off the deep edge, so that each line lies up the slope from the one before.
  const Angle slope = Angle::degrees(2.0);
  const Site site(tilted(1000.0, 300.0, 20.0, slope));
  const DesignGround g(site.ground, kOpening, 0.0, 3e5);
  const AreaQuery water(site.ground.water);
  const double margin = 0.08;
  const auto lines = edge_following_lines(g.swaths, water, {{1000.0, 0.0}, {1000.0, 300.0}},
                                          {.margin = margin, .smooth_passes = 10});
  ASSERT_GE(lines.size(), 5U);
  const double rise = tan(slope) * kTan;
  for (std::size_t k = 0; k + 2 < lines.size(); ++k) {
    const auto depth = [&](std::size_t i) {
      return 20.0 + lines[i].points[lines[i].points.size() / 2].x() * tan(slope);
    };
    const double apart = (depth(k) - depth(k + 1)) / tan(slope);
    const double shared =
        depth(k) * kTan / (1.0 + rise) + depth(k + 1) * kTan / (1.0 - rise) - apart;
    // To first order in the slope: a swath is as wide down the slope as up.
    EXPECT_NEAR(shared / (2.0 * depth(k + 1) * kTan), margin, 0.3 * rise + 0.01);
  }
  EXPECT_LE(judge_lines(swept(lines, g.swaths), g.swaths).missed, 1e-3);
}

TEST(EdgeFollowing, PlansConfinedWaterInsideIt) {
  Site site(stepped(60.0, 40.0, 6.0, 10.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions options;
  options.resolution_m = 0.25;
  const Plan plan = plan_edge_following(site.ground, options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  ScoreOptions how;
  how.resolution_m = options.resolution_m;
  how.footprint = false;
  const Score score = swathplan::score(plan.route,
                                       {&site.seafloor, &site.depths, &scene,
                                        site.ground.survey_area, site.ground.water},
                                       options.sonar, options.vehicle, how)
                          .score;
  EXPECT_GE(score.all.hit_pct, 90.0);
  EXPECT_LE(score.route.outside_water_m, 0.01);
}

}  // namespace
}  // namespace swathplan

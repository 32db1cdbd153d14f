#include "planners/fitted/infill.h"

#include <gtest/gtest.h>

#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

/// Two northward lines far apart on flat ground; between them nothing is seen.
struct Gap {
  Gap() : seafloor(flat(60.0, 40.0, 8.0)), depths(seafloor), scene(seafloor, Nodata::wall) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.scene = &scene;
    ground.survey_area = ground.water = survey_area(seafloor, {});
    options.resolution_m = 0.25;
    const Vec2 points[] = {{8.0, 1.0}, {8.0, 38.0}, {52.0, 38.0}, {52.0, 1.0}};
    for (int k = 0; k < 4; ++k) {
      Waypoint w;
      w.position = points[k];
      w.kind = k == 1 ? LegKind::transit : LegKind::line;
      if (k != 1) w.line = k == 0 ? 1 : 2;
      w.log = k != 1;
      if (k != 1) w.fan = FanAngles{Angle::degrees(45.0), Angle::degrees(45.0)};
      route.waypoints.push_back(w);
    }
    route.waypoints.back().kind = LegKind::end;
    route.waypoints.back().line.reset();
    route.waypoints.back().log = false;
  }
  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  Ground ground;
  PlanOptions options;
  Route route;
};

TEST(Infill, CountsWhatFootprintsCoverWhereTheyAreAskedFor) {
  Gap gap;
  gap.options.cover = Cover::footprint;
  LineWorkshop shop(gap.ground, gap.options);
  const ScoredRoute before = shop.score(gap.route);
  const InfilledRoute filled = infilled(gap.route, gap.ground, gap.options);
  const ScoredRoute after = shop.score(filled.built.route);
  EXPECT_EQ(shop.cover_pct(before), before.score.all.footprint_pct.value());
  EXPECT_LT(shop.cover_pct(before), 60.0);
  EXPECT_GT(shop.cover_pct(after), 97.0);
}

TEST(Infill, ClosesTheGapBetweenTwoLinesAndKeepsTheirOrder) {
  const Gap gap;
  LineWorkshop shop(gap.ground, gap.options);
  const double before = shop.score(gap.route).score.all.hit_pct;
  const InfilledRoute filled = infilled(gap.route, gap.ground, gap.options);
  ASSERT_EQ(fault(filled.built.route), std::nullopt);
  const Score after = shop.score(filled.built.route).score;
  EXPECT_LT(before, 60.0);
  EXPECT_GT(after.all.hit_pct, 95.0);
  EXPECT_GE(filled.passes, 1U);
  EXPECT_LE(after.route.outside_water_m, 0.01);
  int last = 0;
  for (const Waypoint& w : filled.built.route.waypoints) {
    if (w.kind != LegKind::line || !w.line) continue;
    EXPECT_GE(*w.line, last);
    last = *w.line;
  }
  EXPECT_EQ(last, 2);
}

TEST(Infill, StopsOncePassesPromiseEnough) {
  const Gap gap;
  LineWorkshop shop(gap.ground, gap.options);
  const CoverageGrid grid = shop.score(gap.route).grid;
  const InfilledRoute all = with_infill(gap.route, grid, shop);
  const InfilledRoute some = with_infill(gap.route, grid, shop, {.enough_m2 = 1.0});
  EXPECT_GT(all.passes, 1U);
  EXPECT_EQ(some.passes, 1U);
  EXPECT_TRUE(some.enough);
  EXPECT_FALSE(all.enough);
}

TEST(Infill, LegsOfALineStayTogether) {
  Gap gap;
  // The first line changes its fan half-way.
  Waypoint middle = gap.route.waypoints[0];
  middle.position = {8.0, 20.0};
  middle.line = 3;
  middle.fan = FanAngles{Angle::degrees(40.0), Angle::degrees(40.0)};
  gap.route.waypoints.insert(gap.route.waypoints.begin() + 1, middle);
  LineWorkshop shop(gap.ground, gap.options);
  const InfilledRoute filled =
      with_infill(gap.route, shop.score(gap.route).grid, shop, {.least_gain = 0.06});
  ASSERT_GE(filled.passes, 1U);
  const auto& w = filled.built.route.waypoints;
  for (std::size_t i = 1; i < w.size(); ++i) {
    if (w[i].line != 3 || w[i - 1].line == 3) continue;
    EXPECT_EQ(w[i - 1].line, 1);
    EXPECT_EQ(w[i].position, Vec2(8.0, 20.0));
  }
}

TEST(Infill, LeavesARouteAloneThatHasEnough) {
  const Gap gap;
  const InfilledRoute same = infilled(gap.route, gap.ground, gap.options, 1.0);
  EXPECT_EQ(same.passes, 0U);
  ASSERT_EQ(same.built.route.waypoints.size(), gap.route.waypoints.size());
}

}  // namespace
}  // namespace swathplan

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

TEST(Infill, LeavesARouteAloneThatHasEnough) {
  const Gap gap;
  const InfilledRoute same = infilled(gap.route, gap.ground, gap.options, 1.0);
  EXPECT_EQ(same.passes, 0U);
  ASSERT_EQ(same.built.route.waypoints.size(), gap.route.waypoints.size());
}

}  // namespace
}  // namespace swathplan

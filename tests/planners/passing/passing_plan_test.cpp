#include "planners/passing/passing_plan.h"

#include <gmock/gmock.h>

#include "coverage/standards/criterion_fan.h"
#include "mesh/synthetic.h"
#include "planners/fronts/rate_width.h"
#include "planners/fronts/water_raster.h"
#include "planners/passing/gap_passes.h"
#include "planners/passing/paced_lines.h"
#include "planners/passing/shown_cells.h"
#include "planners/passing/spared_lines.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

UncertaintyBudget good_budget() {
  UncertaintyBudget budget;
  use_sonar("em2040", budget);
  use_positioning("rtk", budget);
  use_motion_sensor("ins", budget);
  budget.beam_width_along = Angle::degrees(1);
  budget.mean_sound_speed_mps = 1.0;
  budget.head_sound_speed_mps = 0.25;
  budget.draft_m = budget.squat_m = 0.02;
  return budget;
}

/// Seldom enough for a test to be short, and often enough for cubes of 1 m.
Sonar slow_sonar() {
  Sonar sonar = *sonar_preset("em2040");
  sonar.max_opening = Angle::degrees(130);
  sonar.max_ping_rate_hz = 10.0;
  return sonar;
}

/// A floor, a criterion and the options to plan for it.
struct PassingSite {
  PassingSite(Seafloor floor, const char* name)
      : site(std::move(floor), 0.0, 15.0),
        scene(site.seafloor, Nodata::open),
        judge(with_scene(), criterion(name), good_budget(),
              {.smooth_seafloor = true, .rules = {}}) {
    options.pings.spacing_m.reset();
    options.counted = Counted::logged;
    options.angles = Angles::line;
    options.sonar = slow_sonar();
    options.vehicle.draft_m = 0.5;
    options.vehicle.turn_radius_m = 4.0;
    options.least_line_m = 16.0;
    options.resolution_m = 1.0;
    const DepthRange depths = depth_range(site.seafloor);
    options.sonar = narrowed_to(judge.criterion(), judge.uncertainty(), options.sonar,
                                {depths.min - 0.5, depths.max - 0.5}, 0.5, 2.0);
  }
  const Ground& with_scene() {
    site.ground.scene = &scene;
    return site.ground;
  }
  [[nodiscard]] Verdict verdict(const Route& route, std::uint64_t seed = 0) const {
    ScoreOptions scoring;
    scoring.pings = options.pings;
    scoring.resolution_m = 1.0;
    if (seed > 0) {
      scoring.noise.lateral_sigma_m = 0.3;
      scoring.noise.heading_sigma = Angle::degrees(2);
      scoring.noise.seed = seed;
    }
    return judge.judge(route, slow_sonar(), options.vehicle, scoring).verdict;
  }
  TestSite site;
  RayScene scene;
  SurveyJudge judge;
  PlanOptions options;
};

TEST(PassingPlan, IsPredictedToPassOnALevelFloorAlsoInCalmWeather) {
  const PassingSite site(flat(40, 30, 7), "s44-special");
  const Plan plan = plan_to_pass(site.judge, site.options);
  ASSERT_EQ(fault(plan.route), std::nullopt);
  EXPECT_TRUE(site.verdict(plan.route).pass) << sentence(site.verdict(plan.route));
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    EXPECT_TRUE(site.verdict(plan.route, seed).pass) << seed;
  }
}

TEST(PassingPlan, PassesTwoHundredPerCentToo) {
  const PassingSite site(flat(24, 20, 6), "s44-exclusive");
  const Plan plan = plan_to_pass(site.judge, site.options);
  EXPECT_TRUE(site.verdict(plan.route).pass) << sentence(site.verdict(plan.route));
}

TEST(PassingPlan, LaysLinesFarApartWhereDepthsMayLieFarApart) {
  const PassingSite dense(flat(110, 80, 5), "s44-1a");
  const PassingSite sparse(flat(110, 80, 5), "s44-2");
  const Plan wide = plan_to_pass(sparse.judge, sparse.options);
  EXPECT_TRUE(sparse.verdict(wide.route).pass) << sentence(sparse.verdict(wide.route));
  const Plan close = plan_to_pass(dense.judge, dense.options);
  EXPECT_TRUE(dense.verdict(close.route).pass) << sentence(dense.verdict(close.route));
  EXPECT_LT(sailing_s(wide.route), 0.75 * sailing_s(close.route));
  EXPECT_THAT(wide.notes, Contains(HasSubstr("of the distance that depths may lie apart")));
  EXPECT_THAT(close.notes, Contains(HasSubstr("held against a boat 0.9 m off its line")));
}

TEST(LeastHoursByCriterion, AreOfTheFanThatItAcceptsAndOfTwoLinesWhereItAsksForThem) {
  PassingSite site(flat(40, 30, 20), "s44-exclusive");
  const WaterRaster raster(site.site.ground);
  const double plain = least_hours(raster, site.options);
  site.options.criterion = &site.judge.criterion();
  site.options.uncertainty = &site.judge.uncertainty();
  const auto asked = asked_by(site.judge.criterion(), site.judge.uncertainty(),
                              rate_question(site.options), 19.5, 0.5);
  ASSERT_TRUE(asked.has_value());
  const double rate = best_area_rate(*asked, 19.5)->rate_m2ps;
  EXPECT_NEAR(least_hours(raster, site.options), 2.0 * 40.0 * 30.0 / rate / 3600.0,
              0.02 * 2.0 * 40.0 * 30.0 / rate / 3600.0);
  EXPECT_GT(least_hours(raster, site.options), 2.0 * plain);
}

Route one_line(double speed_mps) {
  Route route;
  for (const double y : {0.0, 60.0}) {
    Waypoint w;
    w.position = {30.0, y};
    w.fan = FanAngles{Angle::degrees(60), Angle::degrees(60)};
    w.speed_mps = speed_mps;
    w.line = 1;
    route.waypoints.push_back(w);
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

TEST(PacedLines, KeepThePingsAsCloseAsTheCubeAsks) {
  PassingSite site(flat(60, 60, 40), "s44-special");
  site.options.vehicle.speed_mps = 6.0;
  Route route = one_line(6.0);
  pace_lines(route, site.judge, site.options, 1.0);
  // 39.5 m below the sonar a ping each 2 x 79 / (0.9 x 1500) s, 1 / 3 m apart at most.
  const double most = 0.95 * (1.0 / 3.0) / (2.0 * 79.0 / 1350.0);
  EXPECT_NEAR(route.waypoints[0].speed_mps, std::floor(10.0 * most) / 10.0, 1e-9);
  pace_lines(route, site.judge, site.options, 0.5);
  EXPECT_LE(route.waypoints[0].speed_mps, 0.5 * most + 1e-9);
}

TEST(ShownCells, AreCoveredWhateverSideTheBoatIsOff) {
  const PassingSite site(flat(60, 60, 10), "s44-1a");
  const auto covered = [&](double aside) {
    ShownCells shown(site.judge, site.options, {aside, Angle::degrees(0)});
    shown.show(one_line(2.0));
    const std::vector<JudgedGrid> grids = shown.grids();
    double width = 0.0;
    for (std::size_t c = 0; c < grids[0].columns; ++c) {
      width += grids[0].cells[30 * grids[0].columns + c].accepted > 0 ? grids[0].cell_m : 0.0;
    }
    return width;
  };
  EXPECT_NEAR(covered(0.0), 2.0 * 9.5 * std::tan(M_PI / 3.0), 2.0);
  EXPECT_NEAR(covered(0.0) - covered(2.0), 4.0, 1.01);
}

/// One line at x, and another that many metres beside it, with a join between.
Route two_lines(double x, double apart) {
  Route route = one_line(2.0);
  for (Waypoint& w : route.waypoints) w.position.x() = x;
  route.waypoints.back().kind = LegKind::turn;
  route.waypoints.back().log = false;
  route.waypoints.back().line.reset();
  for (Waypoint w : one_line(2.0).waypoints) {
    w.position.x() = x + apart;
    if (w.line) w.line = 2;
    route.waypoints.push_back(w);
  }
  return route;
}

TEST(ShownCells, TraceOnlyLinesThatAreNew) {
  const PassingSite site(flat(60, 60, 10), "s44-1a");
  ShownCells shown(site.judge, site.options, {0.5, Angle::degrees(2)});
  shown.show(one_line(2.0));
  EXPECT_EQ(shown.traced(), 1U);
  shown.show(two_lines(30.0, 5.0));
  EXPECT_EQ(shown.traced(), 2U);
  EXPECT_EQ(shown.lines().size(), 2U);
  // The same as if all were traced at once.
  ShownCells anew(site.judge, site.options, {0.5, Angle::degrees(2)});
  anew.show(two_lines(30.0, 5.0));
  const JudgedGrid a = shown.grids().front();
  const JudgedGrid b = anew.grids().front();
  // Pings of the second line begin elsewhere within their spacing, which cells of the rim show.
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    unlike += a.cells[i].lines != b.cells[i].lines ? 1U : 0U;
  }
  EXPECT_LT(unlike, a.cells.size() / 50);
}

TEST(SparedLines, AreThoseThatOthersStandInFor) {
  const PassingSite site(flat(60, 60, 20), "s44-1a");
  // Either line sees all of the floor but what lies near its ends.
  const Route route = two_lines(28.0, 4.0);
  ShownCells shown(site.judge, site.options, {0.5, Angle::degrees(0)});
  shown.show(route);
  const auto gaps = [&] {
    const CellMask mask = gaps_in(site.judge.criterion(), shown.grids().front());
    return std::count(mask.begin(), mask.end(), 1);
  };
  const auto before = gaps();
  const auto rest = spared(route, shown, 16.0);
  ASSERT_TRUE(rest.has_value());
  EXPECT_EQ(rest->lines, 1U);
  EXPECT_EQ(gaps(), before);
  ASSERT_EQ(rest->stretches.size(), 1U);
  EXPECT_FALSE(rest->stretches.front().join);
  // Lines far apart both stay.
  const Route apart = two_lines(12.0, 36.0);
  const PassingSite shoal(flat(60, 60, 8), "s44-1a");
  ShownCells both(shoal.judge, shoal.options, {0.5, Angle::degrees(0)});
  both.show(apart);
  const auto kept = spared(apart, both, 16.0);
  EXPECT_TRUE(!kept || kept->lines == 0U);
}

TEST(GapPasses, SeeWhatTheyAreFor) {
  PassingSite site(flat(60, 60, 10), "s44-1a");
  LineWorkshop shop(site.site.ground, site.options);
  const Route route = one_line(2.0);
  Itinerary itinerary(route, shop.joins());
  const std::vector<GapCell> cells{{{55, 30}, 10.0, 1}, {{55, 31}, 10.0, 2}};
  const GapPasses added = insert_gap_passes(cells, shop,
                                            {.unsteady = {0.5, Angle::degrees(2)},
                                             .end_share = 0.1,
                                             .fewest_cells = 1,
                                             .most_passes = 10,
                                             .barred = {}},
                                            itinerary);
  EXPECT_EQ(added.passes, 2U);
  EXPECT_EQ(added.cells_left, 0U);
  const Route with = shop.join(itinerary.runs()).route;
  std::vector<Waypoint> passes;
  for (const Waypoint& w : with.waypoints) {
    if (w.kind == LegKind::infill) passes.push_back(w);
  }
  ASSERT_FALSE(passes.empty());
  for (const Waypoint& w : passes) {
    EXPECT_LE(std::abs(w.position.x() - 55.0), 9.5 * std::tan(Angle::degrees(65).rad()));
  }
}

}  // namespace
}  // namespace swathplan

#include "coverage/judging/judged_survey.h"

#include <gmock/gmock.h>

#include <cmath>

#include "coverage/judging/criterion_grids.h"
#include "coverage/judging/judged_soundings.h"
#include "coverage/scenes.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using ::testing::HasSubstr;
using testing::rectangle;
using testing::route_through;
using testing::TestGround;

UncertaintyBudget launch_budget() {
  UncertaintyBudget budget;
  use_sonar("em2040", budget);
  use_positioning("rtk", budget);
  use_motion_sensor("mru", budget);
  budget.beam_width_along = Angle::degrees(1);
  budget.mean_sound_speed_mps = 1.0;
  budget.head_sound_speed_mps = 0.25;
  budget.draft_m = budget.squat_m = 0.02;
  return budget;
}

FanAngles fan_of(double half_deg) { return {Angle::degrees(half_deg), Angle::degrees(half_deg)}; }

ScoreOptions metre_cells() {
  ScoreOptions scoring;
  scoring.resolution_m = 1.0;
  return scoring;
}

Sonar narrow_beams() { return *sonar_preset("em2040"); }

Vehicle with_draft(double draft_m) {
  Vehicle vehicle;
  vehicle.draft_m = draft_m;
  return vehicle;
}

JudgedSurvey judge_survey(const Route& route, const Ground& ground, const Criterion& criterion,
                          const UncertaintyBudget& budget, const ScoreOptions& scoring,
                          bool smooth = true) {
  return SurveyJudge(ground, criterion, budget, {.smooth_seafloor = smooth, .rules = {}})
      .judge(route, narrow_beams(), with_draft(0.5), scoring);
}

/// Lines along north over 60 x 60 m, `spacing` apart, each numbered, joined by legs that log not.
Route lawn(double spacing, double half_deg, double from = 5.0) {
  Route route;
  int line = 0;
  for (double x = from; x < 60.0; x += spacing, ++line) {
    const bool north = line % 2 == 0;
    for (const bool first : {true, false}) {
      Waypoint w;
      w.position = {x, first == north ? -20.0 : 80.0};
      w.fan = fan_of(half_deg);
      w.kind = first ? LegKind::line : LegKind::turn;
      w.log = first;
      if (first) w.line = line;
      route.waypoints.push_back(w);
    }
  }
  route.waypoints.back().kind = LegKind::end;
  return route;
}

/// Over a floor that the boat may sail all over, and beyond.
struct JudgedSite {
  explicit JudgedSite(Seafloor floor)
      : site(std::move(floor), Nodata::open, rectangle(0, 0, 60, 60)) {
    site.ground.water = rectangle(-50, -50, 110, 110);
  }
  [[nodiscard]] JudgedSurvey judged(const Route& route, const char* name, int threads = 0) const {
    ScoreOptions scoring;
    scoring.resolution_m = 1.0;
    scoring.pings.spacing_m = 0.2;
    scoring.threads = threads;
    return judge_survey(route, site.ground, criterion(name), launch_budget(), scoring);
  }
  TestGround site;
};

TEST(JudgedSurvey, OfDenseLinesOverALevelFloorPasses) {
  const JudgedSite site(flat(60, 60, 10));
  const JudgedSurvey survey = site.judged(lawn(15, 55), "s44-special");
  EXPECT_TRUE(survey.verdict.pass) << sentence(survey.verdict);
  EXPECT_EQ(survey.accepted, survey.soundings);
  EXPECT_GT(survey.pings, 1000U);
  EXPECT_EQ(survey.out_of_reach.total_m2(), 0.0);
  EXPECT_NEAR(survey.verdict.judged_m2, 3600.0, 1e-6);
}

TEST(JudgedSurvey, OfLinesTooFarApartFailsByItsGapsAndSaysWhere) {
  const JudgedSite site(flat(60, 60, 10));
  const JudgedSurvey survey = site.judged(lawn(50, 55), "s44-special");
  EXPECT_FALSE(survey.verdict.pass);
  EXPECT_THAT(sentence(survey.verdict), HasSubstr("predicted to fail IHO S-44 Special Order: cov"));
  ASSERT_FALSE(survey.verdict.rules[0].where.empty());
  EXPECT_NEAR(survey.verdict.rules[0].where[0].position.x(), 30.0, 3.0);
}

TEST(JudgedSurvey, CountsLoggedLegsAlone) {
  const JudgedSite site(flat(60, 60, 10));
  Route route = lawn(15, 55);
  for (Waypoint& w : route.waypoints) w.log = false;
  const JudgedSurvey survey = site.judged(route, "s44-1a");
  EXPECT_EQ(survey.pings, 0U);
  EXPECT_FALSE(survey.verdict.pass);
}

TEST(JudgedSurvey, TwoHundredPerCentNeedTwoLinesOverEachPlace) {
  const JudgedSite site(flat(60, 60, 10));
  EXPECT_FALSE(site.judged(lawn(15, 45), "s44-exclusive").verdict.rules[0].pass);
  EXPECT_TRUE(site.judged(lawn(7, 45, -3.5), "s44-exclusive").verdict.rules[0].pass);
}

TEST(JudgedSurvey, IsTheSameForAnyNumberOfThreads) {
  const JudgedSite site(stepped(60, 60, 8, 14));
  const JudgedSurvey one = site.judged(lawn(20, 60), "s44-special", 1);
  const JudgedSurvey two = site.judged(lawn(20, 60), "s44-special", 2);
  EXPECT_EQ(one.raster.tvu_m, two.raster.tvu_m);
  EXPECT_EQ(one.raster.thu_m, two.raster.thu_m);
  EXPECT_EQ(one.tvu_histogram, two.tvu_histogram);
  EXPECT_EQ(sentence(one.verdict), sentence(two.verdict));
}

TEST(JudgedSurvey, SoundingsBeyondTheLimitDoNotCount) {
  // In 40 m the outermost beams miss Special Order's TVU.
  const JudgedSite site(flat(60, 60, 40));
  UncertaintyBudget budget = launch_budget();
  budget.roll = Angle::degrees(0.3);
  const SoundingGeometry rim{Angle::degrees(60), 39.5 / 0.5, 2.0};
  ASSERT_GT(sounding_uncertainty(budget, rim).tvu_m, tvu_limit_m(criterion("s44-special"), 40));
  ScoreOptions scoring;
  scoring.resolution_m = 1.0;
  const JudgedSurvey survey =
      judge_survey(lawn(200, 65), site.site.ground, criterion("s44-special"), budget, scoring);
  EXPECT_LT(survey.accepted, survey.soundings);
  std::uint64_t beyond = 0;
  for (std::size_t bin = 10; bin < kTvuBins; ++bin) beyond += survey.tvu_histogram[bin];
  EXPECT_NEAR(static_cast<double>(survey.soundings - survey.accepted), static_cast<double>(beyond),
              0.001 * static_cast<double>(survey.soundings));
  EXPECT_FALSE(survey.verdict.rules[0].pass);
}

TEST(JudgedSurvey, LeavesOutWhatNoSafePlaceSees) {
  // Safe water in the west alone; the step's wall hides the ground behind it.
  JudgedSite site(stepped(60, 60, 4, 20));
  site.site.ground.water = rectangle(-10, -10, 20, 70);
  Route route = route_through({{15, -5}, {15, 65}}, fan_of(70));
  const JudgedSurvey survey = site.judged(route, "s44-1a");
  EXPECT_GT(survey.out_of_reach.total_m2(), 500.0);
  EXPECT_LT(survey.out_of_reach.total_m2(), 60.0 * 30.0 + 60.0);
  EXPECT_NEAR(survey.verdict.judged_m2 + survey.out_of_reach.total_m2(), 3600.0, 1e-6);
}

TEST(JudgedSurvey, RefusesCellsFinerThanTheDataUnlessTheGroundIsSmooth) {
  const JudgedSite site(flat(60, 60, 10));
  const auto judged = [&](const char* name, bool smooth) {
    return judge_survey(lawn(15, 55), site.site.ground, criterion(name), launch_budget(),
                        metre_cells(), smooth);
  };
  EXPECT_NEAR(data_spacing_m(site.site.seafloor), 1.0, 1e-9);
  EXPECT_NO_THROW((void)judged("s44-1a", false));
  EXPECT_NO_THROW((void)judged("s44-special", true));
  try {
    (void)judged("s44-special", false);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("it judges cells of 0.5 m and the seafloor is known by "
                                        "points 1 m apart"));
  }
}

TEST(JudgedSurvey, RefusesABudgetWithoutADeviation) {
  const JudgedSite site(flat(60, 60, 10));
  UncertaintyBudget budget = launch_budget();
  budget.pitch.reset();
  EXPECT_THROW((void)judge_survey(lawn(15, 55), site.site.ground, criterion("s44-1a"), budget,
                                  metre_cells()),
               UsageError);
}

TEST(CriterionGrids, SplitTheAreaByDepth) {
  TestGround site(stepped(60, 60, 30, 60), Nodata::open, rectangle(0, 0, 60, 60));
  const std::vector<JudgedGrid> grids = criterion_grids(criterion("s44-1a"), site.ground);
  ASSERT_EQ(grids.size(), 2U);
  EXPECT_EQ(grids[0].cell_m, 1.0);
  EXPECT_EQ(grids[1].cell_m, 2.0);
  double area = 0.0;
  for (const JudgedGrid& grid : grids) {
    for (const JudgedCell& cell : grid.cells) {
      if (!cell.asked) continue;
      area += grid.cell_m * grid.cell_m;
      EXPECT_EQ(cell.depth_m > 40.0F, grid.cell_m == 2.0);
    }
  }
  EXPECT_NEAR(area, 3600.0, 130.0);  // cells along the wall fall to either side or twice
}

TEST(CriterionGrids, RefuseTooManyCells) {
  TestGround site(flat(9000, 9000, 100), Nodata::open, rectangle(0, 0, 9000, 9000));
  EXPECT_THROW((void)criterion_grids(criterion("s44-exclusive"), site.ground), UsageError);
}

/// A ping at (30, 30), heading north, at 2 m/s.
Ping ping_of(double half_deg) {
  Ping ping;
  ping.position = {30, 30};
  ping.fan = fan_of(half_deg);
  ping.speed_mps = 2.0;
  return ping;
}

/// Its soundings; pings 0.4 m apart.
std::vector<JudgedSounding> soundings_of(const Ping& ping, const Seafloor& floor,
                                         const char* name) {
  const RayScene scene(floor, Nodata::open);
  const CoverageGrid grid(rectangle(0, 0, 60, 60), 1.0);
  const Sonar sonar = narrow_beams();
  PingTracer rays(scene, sonar, 0.5, grid, Bands{}, false, 1.0);
  TracedPings block;
  block.pings = {ping};
  rays.trace_rays(ping, block.hits);
  block.spacing_m = {0.4};
  block.line = {1};
  const UncertaintyModel model(launch_budget());
  SoundingMaker maker(sonar, 0.5, 1.0, criterion(name), model);
  std::vector<JudgedSounding> soundings;
  maker.append(block, soundings);
  return soundings;
}

/// A thousandth of it.
void expect_close(double value, double exact) { EXPECT_NEAR(value, exact, 1e-3 * exact); }

TEST(JudgedSoundings, FollowsTheClosedFormsOverALevelFloor) {
  const auto soundings = soundings_of(ping_of(60), flat(60, 60, 10), "s44-special");
  ASSERT_EQ(soundings.size(), 400U);
  for (std::size_t i = 0; i < 400; ++i) {
    const double t = (-60.0 + 120.0 * static_cast<double>(i) / 399.0) * M_PI / 180.0;
    const double below = 9.5;
    expect_close(soundings[i].position.x(), 30.0 + below * std::tan(t));
    expect_close(soundings[i].depth_m, 10.0);
    const SoundingUncertainty exact = sounding_uncertainty(
        launch_budget(), {Angle::radians(std::abs(t)), below / std::cos(t), 2.0});
    expect_close(soundings[i].tvu_m, exact.tvu_m);
    expect_close(soundings[i].thu_m, exact.thu_m);
    expect_close(soundings[i].feature_pings, 1.0 / 0.4);
    const double spacing = below * (120.0 * M_PI / 180.0 / 399.0) / std::pow(std::cos(t), 2);
    expect_close(soundings[i].feature_beams, 1.0 / spacing);
  }
}

TEST(JudgedSoundings, FollowsTheClosedFormsOverATiltedFloor) {
  const Angle slope = Angle::degrees(20);
  const auto soundings = soundings_of(ping_of(45), tilted(60, 60, 5, slope), "s44-1a");
  ASSERT_EQ(soundings.size(), 400U);
  for (std::size_t i = 0; i < 400; ++i) {
    const double t = (-45.0 + 90.0 * static_cast<double>(i) / 399.0) * M_PI / 180.0;
    const double below = 5.0 + 30.0 * tan(slope) - 0.5;
    const double range = below / (std::cos(t) - std::sin(t) * tan(slope));
    const SoundingUncertainty exact =
        sounding_uncertainty(launch_budget(), {Angle::radians(std::abs(t)), range, 2.0});
    expect_close(soundings[i].tvu_m, exact.tvu_m);
    expect_close(soundings[i].thu_m, exact.thu_m);
  }
}

TEST(JudgedSoundings, FollowsTheClosedFormsOnBothSidesOfAStep) {
  for (const JudgedSounding& s : soundings_of(ping_of(45), stepped(60, 60, 12, 8), "s44-1a")) {
    const double side = s.position.x() - 30.0;
    if (std::abs(side) < 1.0) continue;  // the wall
    const double below = (side < 0.0 ? 12.0 : 8.0) - 0.5;
    const SoundingUncertainty exact = sounding_uncertainty(
        launch_budget(),
        {Angle::radians(std::atan2(std::abs(side), below)), std::hypot(side, below), 2.0});
    expect_close(s.tvu_m, exact.tvu_m);
    expect_close(s.thu_m, exact.thu_m);
  }
}

TEST(JudgedSoundings, TurnTheFanWithTheRoll) {
  Ping ping = ping_of(30);
  ping.roll = Angle::degrees(10);
  const auto soundings = soundings_of(ping, flat(60, 60, 10), "s44-1a");
  expect_close(soundings.front().position.x(), 30.0 - 9.5 * std::tan(40.0 * M_PI / 180.0));
}

TEST(JudgedSoundings, AreThoseOfLoggedPingsAlone) {
  Ping ping = ping_of(30);
  ping.log = false;
  EXPECT_TRUE(soundings_of(ping, flat(60, 60, 10), "s44-1a").empty());
}

/// All pings of lines 20 m apart over a level floor 10 m deep.
TracedPings traced(const ScoreOptions& scoring) {
  const TestGround site(flat(60, 60, 10), Nodata::open, rectangle(0, 0, 60, 60));
  const CoverageGrid grid(rectangle(0, 0, 60, 60), 1.0);
  const Route route = lawn(20, 45);
  const Sonar sonar = narrow_beams();
  TracedPingReader reader(route, site.scene, sonar, 0.5, scoring, grid);
  TracedPings all;
  EXPECT_TRUE(reader.next(1000000, all));
  return all;
}

TEST(TracedPings, KnowTheirLineSpeedAndSpacing) {
  ScoreOptions scoring;
  scoring.pings.spacing_m = 0.25;
  const TracedPings all = traced(scoring);
  ASSERT_GT(all.pings.size(), 1190U);
  ASSERT_EQ(all.hits.starts.size(), all.pings.size());
  std::vector<std::uint32_t> lines;
  for (std::size_t i = 0; i < all.pings.size(); ++i) {
    EXPECT_EQ(all.spacing_m[i], 0.25);
    EXPECT_EQ(all.pings[i].speed_mps, 2.0);
    const bool another = lines.empty() || lines.back() != all.line[i];
    if (all.pings[i].log && another) lines.push_back(all.line[i]);
  }
  EXPECT_THAT(lines, ::testing::ElementsAre(2U, 4U, 6U));
}

TEST(TracedPings, ByTheClockStandAsFarApartAsTheSoundLets) {
  ScoreOptions scoring;
  scoring.pings.spacing_m.reset();
  scoring.pings.sound_speed_mps = 400.0;  // so that it binds in shoal water
  const TracedPings all = traced(scoring);
  const double spacing = 2.0 * 2.0 * (9.5 * std::sqrt(2.0)) / (0.9 * 400.0);
  for (std::size_t i = 150; i < 450; ++i) {  // over the floor, on the first line
    if (all.pings[i].position.y() < 5.0 || all.pings[i].position.y() > 55.0) continue;
    expect_close(all.spacing_m[i], spacing);
    if (all.pings[i].leg != all.pings[i + 1].leg) continue;
    expect_close((all.pings[i + 1].position - all.pings[i].position).norm(), spacing);
  }
}

}  // namespace
}  // namespace swathplan

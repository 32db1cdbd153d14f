#include "coverage/score.h"

#include <gtest/gtest.h>

#include "coverage/scenes.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::rectangle;
using testing::route_through;
using testing::TestGround;

Vehicle at_the_surface() {
  Vehicle vehicle;
  vehicle.draft_m = 0.0;
  return vehicle;
}

FanAngles even_fan(double half_deg) { return {Angle::degrees(half_deg), Angle::degrees(half_deg)}; }

/// One pass along the grid over exactly W = 25.6 m.
double single_pass_pct(double depth) {
  const TestGround g(flat(100, 100, depth), Nodata::wall, rectangle(37.2, 30, 62.8, 70));
  const double half = std::atan(12.8 / depth) * 180 / M_PI;
  const Route route = route_through({{50, 20}, {50, 80}}, even_fan(half));
  return score(route, g.ground, {}, at_the_surface(), {}).score.all.hit_pct;
}

TEST(Score, ASinglePassHitsAsManyCellsAsItsBeamsReach) {
  EXPECT_NEAR(single_pass_pct(5), 73, 1);
  EXPECT_NEAR(single_pass_pct(10), 87, 1);
  EXPECT_NEAR(single_pass_pct(20), 95, 1);
}

TEST(Score, CountsTheInnerShareOfEachSideOfASwath) {
  // Sides of 10 and 20 m: of the 30 m swept, half is left, 5 and 10 m off the track.
  const double depth = 10;
  const TestGround g(flat(100, 100, depth), Nodata::wall, rectangle(0, 40, 100, 60));
  const FanAngles fan{Angle::degrees(45), Angle::radians(std::atan(2.0))};
  const Route route = route_through({{50, 20}, {50, 80}}, fan);
  ScoreOptions options;
  options.resolution_m = 0.5;
  options.swath_share = 0.5;
  const ScoredRoute inner = score(route, g.ground, {}, at_the_surface(), options);
  EXPECT_NEAR(inner.score.all.hit_pct, 15.0, 0.5);
  EXPECT_NEAR(inner.score.all.footprint_pct.value(), 15.0, 0.5);
  for (std::uint32_t c = 0; c < inner.grid.columns(); ++c) {
    const double x = inner.grid.centre(c, 10).x();
    const bool hit = inner.grid.soundings(std::size_t{10} * inner.grid.columns() + c) > 0;
    EXPECT_EQ(hit, x > 45.0 && x < 60.0) << x;
  }
  options.swath_share = 1.0;
  EXPECT_NEAR(score(route, g.ground, {}, at_the_surface(), options).score.all.hit_pct, 30.0, 0.5);
  for (const double wrong : {0.0, 1.01, std::nan("")}) {
    options.swath_share = wrong;
    EXPECT_THROW(static_cast<void>(score(route, g.ground, {}, at_the_surface(), options)),
                 UsageError);
  }
}

TEST(Score, CountsEverySoundingInTheCellUnderIt) {
  // Cells of 1 m and pings each metre: every beam's cell is known.
  const double depth = 10;
  const TestGround g(flat(60, 60, depth), Nodata::wall, rectangle(10, 10, 50, 50));
  const Route route = route_through({{30.3, 20.5}, {30.3, 39.5}}, even_fan(50));
  Sonar sonar;
  sonar.beams = 33;
  ScoreOptions options;
  options.resolution_m = 1.0;
  options.pings.spacing_m = 1.0;
  const ScoredRoute scored = score(route, g.ground, sonar, at_the_surface(), options);
  std::vector<std::uint32_t> expected(40 * 40, 0);
  for (const double angle : beam_angles_rad(sonar, even_fan(50))) {
    const double column = std::floor(30.3 + depth * std::tan(angle) - 10);
    for (std::size_t row = 10; row < 30; ++row) {
      ++expected[row * 40 + static_cast<std::size_t>(column)];
    }
  }
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(scored.grid.soundings(i), expected[i]) << i;
    total += expected[i];
  }
  EXPECT_EQ(scored.score.pings, 20U);
  EXPECT_EQ(scored.score.rays, 20U * 33U);
  EXPECT_EQ(scored.score.soundings, total);
  EXPECT_EQ(scored.score.cells, 1600U);
}

TEST(Score, PortAndStarboardAreWhereTheCourseSays) {
  const TestGround g(flat(60, 60, 10), Nodata::wall, rectangle(0, 0, 60, 60));
  const FanAngles to_starboard{Angle::degrees(1), Angle::degrees(60)};
  // Sailing north, starboard is east.
  const Route route = route_through({{30, 20}, {30, 40}}, to_starboard);
  const ScoredRoute s = score(route, g.ground, {}, at_the_surface(), {});
  std::size_t west = 0;
  std::size_t east = 0;
  for (std::uint32_t r = 0; r < s.grid.rows(); ++r) {
    for (std::uint32_t c = 0; c < s.grid.columns(); ++c) {
      const bool hit = s.grid.soundings(std::size_t{r} * s.grid.columns() + c) > 0;
      const double x = s.grid.centre(c, r).x();
      west += hit && x < 29.5;
      east += hit && x > 30.5;
    }
  }
  EXPECT_EQ(west, 0U);
  EXPECT_GT(east, 1000U);
}

Route winding(double half_deg) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 400; ++i) {
    const double t = i / 400.0 * 6 * M_PI;
    points.emplace_back(t * std::cos(t), t * std::sin(t));
  }
  Route route = route_through(points, even_fan(half_deg));
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    route.waypoints[i].log = i % 90 < 60;
    route.waypoints[i].line = static_cast<int>(i / 40);
  }
  return route;
}

TEST(Score, IsTheSameForAnyNumberOfThreads) {
  const Seafloor floor = saddle();
  const TestGround g(floor, Nodata::wall, outline(floor));
  ScoreOptions options;
  options.pings.spacing_m = 0.2;
  options.noise.roll_sigma = Angle::degrees(2);
  options.noise.lateral_sigma_m = 0.3;
  options.threads = 1;
  const ScoredRoute one = score(winding(40), g.ground, {}, {}, options);
  for (const int threads : {2, 3, 2}) {
    options.threads = threads;
    const ScoredRoute other = score(winding(40), g.ground, {}, {}, options);
    EXPECT_TRUE(one.grid.words() == other.grid.words()) << threads;
    EXPECT_EQ(one.score.soundings, other.score.soundings);
    EXPECT_EQ(one.score.all.footprint_pct, other.score.all.footprint_pct);
    EXPECT_EQ(one.score.overlap, other.score.overlap);
  }
}

TEST(Score, LoggedFiguresCountLoggedLegsOnly) {
  const TestGround g(flat(100, 100, 10), Nodata::wall, rectangle(20, 20, 80, 80));
  Route both = route_through({{50, 10}, {50, 50}, {50, 90}}, even_fan(50));
  both.waypoints[1].log = false;
  const Score with_transit = score(both, g.ground, {}, {}, {}).score;
  Route silent = both;
  silent.waypoints[1].fan.reset();
  const Score logged_only = score(silent, g.ground, {}, {}, {}).score;
  EXPECT_GT(with_transit.all.hit_pct, 1.9 * logged_only.all.hit_pct);
  EXPECT_EQ(with_transit.logged.hit_pct, logged_only.all.hit_pct);
  EXPECT_EQ(with_transit.logged.hit_2_pct, logged_only.all.hit_2_pct);
  EXPECT_EQ(with_transit.logged.footprint_pct, logged_only.all.footprint_pct);
}

TEST(Score, HolidaysAreThoseOfLoggedPingsWhereTheseCount) {
  const TestGround g(flat(100, 100, 10), Nodata::wall, rectangle(20, 20, 80, 80));
  Route both = route_through({{50, 10}, {50, 50}, {50, 90}}, even_fan(50));
  both.waypoints[1].log = false;
  const Score all = score(both, g.ground, {}, {}, {}).score;
  ScoreOptions options;
  options.logged_counts = true;
  const Score logged = score(both, g.ground, {}, {}, options).score;
  EXPECT_EQ(all.counted().hit_pct, all.all.hit_pct);
  EXPECT_EQ(logged.counted().hit_pct, logged.logged.hit_pct);
  const auto share = [](const Score& s) { return 100.0 * s.holidays.total_m2 / s.survey_area_m2; };
  EXPECT_NEAR(share(all), 100.0 - all.all.hit_pct, 0.01);
  EXPECT_NEAR(share(logged), 100.0 - logged.logged.hit_pct, 0.01);
}

TEST(Score, OverlapAndLegsAreCountedPerCell) {
  const TestGround g(flat(100, 100, 10), Nodata::wall, rectangle(37.2, 30, 62.8, 70));
  const double half = std::atan(12.8 / 10.0) * 180 / M_PI;
  Route twice = route_through({{50, 20}, {50, 80}, {50, 80}, {50, 20}}, even_fan(half));
  twice.waypoints[2].line = 1;
  twice.waypoints[1].fan.reset();
  const Score one =
      score(route_through({{50, 20}, {50, 80}}, even_fan(half)), g.ground, {}, {}, {}).score;
  const Score two = score(twice, g.ground, {}, {}, {}).score;
  EXPECT_EQ(one.several_legs_pct, 0.0);
  EXPECT_GT(two.several_legs_pct, 80.0);
  EXPECT_NEAR(two.overlap, 2 * one.overlap + 1, 0.15);
}

TEST(Score, RollSwingsTheFanToPortWhenStarboardGoesDown) {
  // A roll of +10 degrees on a fan of 20 to each side is a fan of 30 to port and 10 to starboard.
  const TestGround g(flat(60, 60, 10), Nodata::wall, rectangle(0, 0, 60, 60));
  const Route route = route_through({{30, 20}, {30, 40}}, even_fan(20));
  TrackNoise noise;
  noise.roll_sigma = Angle::degrees(10);
  noise.correlation_length_m = 1e9;
  for (noise.seed = 1; noise.seed < 20; ++noise.seed) {
    const Sonar sonar;
    PingWalker walker(route, sonar, {.spacing_m = 0.1}, noise);
    std::vector<Ping> pings;
    ASSERT_TRUE(walker.next(1, pings));
    const double roll = pings[0].roll.rad();
    if (std::abs(roll) < Angle::degrees(5).rad()) continue;
    ScoreOptions options;
    options.noise = noise;
    const ScoredRoute s = score(route, g.ground, {}, at_the_surface(), options);
    double west = 60;
    double east = 0;
    for (std::size_t i = 0; i < s.grid.words().size(); ++i) {
      if (s.grid.soundings(i) == 0) continue;
      const double x = s.grid.centre(static_cast<std::uint32_t>(i % s.grid.columns()), 0).x();
      west = std::min(west, x);
      east = std::max(east, x);
    }
    EXPECT_NEAR(west, 30 - 10 * std::tan(Angle::degrees(20).rad() + roll), 0.15);
    EXPECT_NEAR(east, 30 + 10 * std::tan(Angle::degrees(20).rad() - roll), 0.15);
  }
}

TEST(Score, TurningAndShiftingEverythingByWholeCellsChangesNoFigure) {
  const auto hit = [](const Vec2& shift, bool quarter_turn) {
    const auto move = [&](const Vec2& p) -> Vec2 {
      return (quarter_turn ? Vec2(-p.y(), p.x()) : p) + shift;
    };
    Seafloor s = saddle();
    for (Vec3& v : s.vertices) v.head<2>() = move(v.head<2>());
    Route route = winding(40);
    for (Waypoint& w : route.waypoints) w.position = move(w.position);
    const TestGround g(s, Nodata::wall, outline(s));
    ScoreOptions options;
    options.resolution_m = 0.25;
    options.pings.spacing_m = 0.25;
    const Score result = score(route, g.ground, {}, {}, options).score;
    return std::pair(result.all.hit_pct, result.all.footprint_pct.value());
  };
  const auto base = hit({0, 0}, false);
  for (const auto& other : {hit({4096, -2048}, false), hit({0, 0}, true)}) {
    EXPECT_NEAR(other.first, base.first, 0.02);
    EXPECT_NEAR(other.second, base.second, 0.02);
  }
}

TEST(Score, ReportsProgressUpToTheEnd) {
  const TestGround g(flat(60, 60, 10), Nodata::wall, rectangle(0, 0, 60, 60));
  ScoreOptions options;
  double share = 0.0;
  std::uint64_t rays = 0;
  options.progress = [&](double s, std::uint64_t r) {
    EXPECT_GE(s, share);
    share = s;
    rays = r;
  };
  const Score s = score(winding(30), g.ground, {}, {}, options).score;
  EXPECT_EQ(share, 1.0);
  EXPECT_EQ(rays, s.rays);
}

TEST(Score, RefusesWhatCannotBeScored) {
  const TestGround g(flat(60, 60, 10), Nodata::wall, rectangle(0, 0, 60, 60));
  Route route = winding(30);
  Sonar sonar;
  sonar.beams = 0;
  EXPECT_THROW((void)score(route, g.ground, sonar, {}, {}), UsageError);
  ScoreOptions options;
  options.threads = -1;
  EXPECT_THROW((void)score(route, g.ground, {}, {}, options), UsageError);
  options = {};
  options.pings.spacing_m = 0;
  EXPECT_THROW((void)score(route, g.ground, {}, {}, options), UsageError);
  options = {};
  options.resolution_m = 0;
  EXPECT_THROW((void)score(route, g.ground, {}, {}, options), UsageError);
  route.waypoints.resize(1);
  EXPECT_THROW((void)score(route, g.ground, {}, {}, {}), InvalidInput);
}

TEST(Score, ByTheClockPingsOverLevelGroundLieAsFarApartAsTheClosedFormSays) {
  const TestGround g(flat(200, 200, 60), Nodata::open, rectangle(0, 0, 200, 200));
  const Route route = route_through({{100, 60}, {100, 140}}, even_fan(40));
  ScoreOptions options;
  options.resolution_m = 1.0;
  options.pings.spacing_m.reset();
  const Vehicle vehicle = at_the_surface();
  const Score s = score(route, g.ground, {}, vehicle, options).score;
  const double spacing = ping_spacing_m(Sonar{}, options.pings, 60.0, Angle::degrees(40),
                                        route.waypoints[0].speed_mps);
  EXPECT_NEAR(s.pinging.mean_spacing_m, spacing, 1e-3 * spacing);
  EXPECT_NEAR(s.pinging.largest_spacing_m, spacing, 1e-3 * spacing);
  EXPECT_EQ(s.pinging.sound_bound, s.pinging.intervals);
  EXPECT_EQ(s.pings, 1U + static_cast<std::uint64_t>(80.0 / spacing));
}

TEST(Score, ByTheClockTheSameForAnyNumberOfThreads) {
  const TestGround g(saddle(), Nodata::wall, rectangle(-40, -40, 40, 40));
  const Route route =
      route_through({{-30, -30}, {-30, 30}, {0, 30}, {0, -30}, {30, -30}}, even_fan(55));
  ScoreOptions options;
  options.resolution_m = 0.5;
  options.pings.spacing_m.reset();
  options.threads = 1;
  const ScoredRoute one = score(route, g.ground, {}, at_the_surface(), options);
  options.threads = 0;
  const ScoredRoute all = score(route, g.ground, {}, at_the_surface(), options);
  EXPECT_EQ(one.grid.words(), all.grid.words());
  EXPECT_EQ(one.score.pings, all.score.pings);
  EXPECT_EQ(one.score.soundings, all.score.soundings);
  EXPECT_GT(one.score.pinging.sound_bound, 0U);
}

TEST(Score, ASwathEndsWhereTheCoverageCurveSaysForItsDepth) {
  const TestGround g(flat(400, 400, 100), Nodata::open, rectangle(0, 0, 400, 400));
  const Route route = route_through({{200, 100}, {200, 300}}, even_fan(60));
  Sonar sonar;
  sonar.coverage_curve = {{50.0, Angle::degrees(65)}, {150.0, Angle::degrees(25)}};
  ScoreOptions options;
  options.resolution_m = 1.0;
  options.footprint = false;
  const ScoredRoute s = score(route, g.ground, sonar, at_the_surface(), options);
  // Half-way between the two limits: 45 degrees, so 100 m to either side.
  double widest = 0.0;
  for (std::size_t i = 0; i < s.grid.words().size(); ++i) {
    if (s.grid.soundings(i) == 0) continue;
    const auto column = static_cast<double>(i % s.grid.columns());
    widest = std::max(widest, std::abs(column + 0.5 - 200.0));
  }
  EXPECT_NEAR(widest, 100.0, 1.0);
}

}  // namespace
}  // namespace swathplan

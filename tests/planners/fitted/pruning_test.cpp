#include "planners/fitted/pruning.h"

#include <gtest/gtest.h>

#include "coverage/route/route_figures.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

/// Northward lines over level ground, each joined to the next by a straight way, with points a
/// metre apart.
struct Lines {
  explicit Lines(const std::vector<double>& easts)
      : seafloor(flat(60.0, 60.0, 8.0)), depths(seafloor), scene(seafloor, Nodata::wall) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.scene = &scene;
    ground.survey_area = ground.water = survey_area(seafloor, {});
    options.resolution_m = 0.5;
    options.counted = Counted::logged;
    options.least_line_m = 20.0;
    options.vehicle.turn_radius_m = 2.0;
    for (std::size_t k = 0; k < easts.size(); ++k) {
      for (int i = 0; i <= 48; ++i) {
        Waypoint w;
        w.position = {easts[k], k % 2 == 0 ? 6.0 + i : 54.0 - i};
        w.line = static_cast<int>(k) + 1;
        w.fan = FanAngles{Angle::degrees(45.0), Angle::degrees(45.0)};
        route.waypoints.push_back(w);
      }
      Waypoint& last = route.waypoints.back();
      last.kind = k + 1 < easts.size() ? LegKind::turn : LegKind::end;
      last.line.reset();
      last.log = false;
    }
  }
  [[nodiscard]] double seconds(const Route& r) const {
    return route_figures(r, options.vehicle, ground.water, depths, 3600.0, 1.0).duration_s;
  }
  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  Ground ground;
  PlanOptions options;
  Route route;
};

TEST(SoundedStretches, PiecesTogetherSoundWhatTheScoreCounts) {
  const Lines lines({15.0, 30.0, 45.0});
  LineWorkshop shop(lines.ground, lines.options);
  const SoundedLines sounded = sounded_stretches(lines.route, shop);
  ASSERT_EQ(sounded.lines.size(), 3U);
  const ScoredRoute scored = shop.score(lines.route);
  EXPECT_EQ(sounded.scored.score.logged.hit_pct, scored.score.logged.hit_pct);
  std::vector<std::uint32_t> counts(scored.grid.words().size(), 0);
  for (const SoundedLine& line : sounded.lines) {
    EXPECT_GT(line.pieces.size(), 10U);
    for (const SoundedPiece& piece : line.pieces) {
      for (const auto& [cell, n] : piece.cells) counts[cell] += n;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!scored.grid.counts(i)) continue;
    EXPECT_EQ(std::min(counts[i], 7U), scored.grid.logged_soundings(i)) << i;
  }
}

TEST(Pruning, DropsALineThatOthersCover) {
  // Swaths are 15 m wide: the line at 30 m is covered by those 6 m beside it.
  const Lines lines({24.0, 36.0, 50.0, 30.0});
  LineWorkshop shop(lines.ground, lines.options);
  const SoundedLines sounded = sounded_stretches(lines.route, shop);
  const double cover = shop.cover_pct(sounded.scored);
  const PrunedRoute less = pruned(sounded, shop, {.goal_pct = cover - 0.5});
  EXPECT_EQ(less.dropped, 1U);
  ASSERT_EQ(fault(less.built.route), std::nullopt);
  EXPECT_LT(lines.seconds(less.built.route), lines.seconds(lines.route) - 20.0);
  EXPECT_GE(shop.cover_pct(shop.score(less.built.route)), cover - 0.6);
  for (const Waypoint& w : less.built.route.waypoints) EXPECT_NE(w.line, 4);
}

TEST(Pruning, ShortensEndsOnBothSidesOfAJoinAndKeepsTheGoal) {
  const Lines lines({15.0, 30.0, 45.0});
  LineWorkshop shop(lines.ground, lines.options);
  const SoundedLines sounded = sounded_stretches(lines.route, shop);
  const double cover = shop.cover_pct(sounded.scored);
  const PrunedRoute less = pruned(sounded, shop, {.goal_pct = cover - 6.0});
  EXPECT_EQ(less.dropped, 0U);
  EXPECT_GE(less.trimmed, 2U);
  EXPECT_LT(lines.seconds(less.built.route), lines.seconds(lines.route));
  const double after = shop.cover_pct(shop.score(less.built.route));
  EXPECT_LT(after, cover - 1.0);
  EXPECT_GE(after, cover - 6.5);
}

TEST(Pruning, LeavesAPlanAloneThatHasNothingToSpare) {
  const Lines lines({15.0, 30.0, 45.0});
  LineWorkshop shop(lines.ground, lines.options);
  const PrunedRoute less = pruned(sounded_stretches(lines.route, shop), shop, {.goal_pct = 100.0});
  EXPECT_EQ(less.dropped + less.trimmed, 0U);
  EXPECT_TRUE(less.built.route.waypoints.empty());
}

TEST(Pruning, DropsWhatIsShorterThanALineMayBe) {
  Lines lines({15.0, 30.0, 45.0});
  lines.options.least_line_m = 60.0;  // all are shorter
  LineWorkshop shop(lines.ground, lines.options);
  const PrunedRoute less = pruned(sounded_stretches(lines.route, shop), shop, {.goal_pct = 0.0});
  EXPECT_EQ(less.dropped, 2U);  // one is left
}

}  // namespace
}  // namespace swathplan

#include "planners/job/beside_lines.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/base/error.h"
#include "mesh/plane/segments.h"
#include "planners/job/job_site.h"

namespace swathplan {
namespace {

TEST(BesideLines, FiveToEachSideOfAStraightLineAreParallelToIt) {
  const GivenShapes shapes{{{{300, 100}, {300, 300}}}, {}, {}};
  const auto paths = paths_beside(shapes, {.to_each_side = 5, .spacing_m = 20.0});
  ASSERT_EQ(paths.size(), 11U);
  std::set<long> eastings;
  for (const auto& path : paths) {
    EXPECT_NEAR(path.front().x(), path.back().x(), 1e-3);
    EXPECT_NEAR(path.front().y(), 100.0, 1e-3) << "sailed as the line is";
    EXPECT_NEAR(path.back().y(), 300.0, 1e-3);
    eastings.insert(std::lround(path.front().x()));
  }
  EXPECT_EQ(eastings, (std::set<long>{200, 220, 240, 260, 280, 300, 320, 340, 360, 380, 400}));
}

TEST(BesideLines, SidesOfABentLineKeepTheirDistance) {
  const std::vector<Vec2> bent{{100, 100}, {300, 120}, {400, 300}};
  for (const auto& path : paths_beside({{bent}, {}, {}}, {.to_each_side = 1, .spacing_m = 20.0})) {
    if (path == bent) continue;
    for (const Vec2& p : path) {
      double nearest = 1e9;
      for (std::size_t i = 0; i + 1 < bent.size(); ++i) {
        nearest = std::min(nearest, distance_to_segment(bent[i], bent[i + 1], p));
      }
      EXPECT_NEAR(nearest, 20.0, 0.05);
    }
  }
}

TEST(BesideLines, AroundAPointTheyAreClosedAtItsDistance) {
  const auto paths = paths_beside({{}, {{300, 200}}, {}}, {.to_each_side = 2, .spacing_m = 20.0});
  ASSERT_EQ(paths.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(paths[k].front(), paths[k].back());
    for (const Vec2& p : paths[k]) {
      EXPECT_NEAR((p - Vec2(300, 200)).norm(), 20.0 * static_cast<double>(k + 1), 1e-3);
    }
  }
}

TEST(BesideLines, ThePlanSeesOutToTheNextLineAndStaysInTheWater) {
  JobSite bench;
  bench.how.resolution_m = 0.01;
  const Plan plan =
      plan_beside({{{{300, 100}, {300, 300}}}, {}, {}}, {.to_each_side = 2, .spacing_m = 20.0},
                  bench.site.ground, bench.how);
  ASSERT_GT(plan.route.waypoints.size(), 10U);
  EXPECT_FALSE(fault(plan.route)) << *fault(plan.route);
  const double below = 20.0 - bench.how.vehicle.draft_m;
  EXPECT_GT(below * tan(plan.route.waypoints.front().fan->port), 20.0);
  std::set<int> numbers;
  for (const Waypoint& w : plan.route.waypoints) {
    if (w.line) numbers.insert(*w.line);
  }
  EXPECT_EQ(numbers, (std::set<int>{1, 2, 3, 4, 5}));
}

TEST(BesideLines, LinesAreCutToTheWaterAndShortPiecesLeftOut) {
  JobSite bench;
  bench.how.least_line_m = 30.0;
  const Plan plan =
      plan_beside({{{{300, -500}, {300, 60}}}, {}, {}}, {.to_each_side = 1, .spacing_m = 20.0},
                  bench.site.ground, bench.how);
  for (const Waypoint& w : plan.route.waypoints) {
    EXPECT_TRUE(contains(bench.site.ground.water, w.position));
  }
  const Plan none =
      plan_beside({{{{300, -500}, {300, 20}}}, {}, {}}, {.to_each_side = 1, .spacing_m = 20.0},
                  bench.site.ground, bench.how);
  EXPECT_TRUE(none.route.waypoints.empty());
}

TEST(BesideLines, RefusesNoSpacing) {
  EXPECT_THROW(check(BesideOptions{.to_each_side = 1, .spacing_m = 0.0}), UsageError);
  EXPECT_THROW(check(BesideOptions{.to_each_side = 0, .spacing_m = 5.0}), UsageError);
}

}  // namespace
}  // namespace swathplan

#include "coverage/judging/out_of_reach.h"

#include <gtest/gtest.h>

#include "coverage/judging/criterion_grids.h"
#include "coverage/judging/steerable_poses.h"
#include "coverage/scenes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using testing::rectangle;
using testing::TestGround;

TEST(SteerablePoses, InOpenWaterAreAllButThoseThatHeadOutAtTheEdge) {
  const SteerablePoses poses(rectangle(0, 0, 60, 60), 5.0);
  EXPECT_TRUE(poses.steerable({30, 30}, {0, 1}));
  EXPECT_TRUE(poses.steerable({30, 30}, {1, 0}));
  EXPECT_TRUE(poses.steerable({2, 30}, {0, 1}));    // along the edge
  EXPECT_FALSE(poses.steerable({2, 30}, {1, 0}));   // nobody comes from there
  EXPECT_FALSE(poses.steerable({58, 30}, {1, 0}));  // nor goes there
  EXPECT_FALSE(poses.steerable({70, 30}, {0, 1}));
}

TEST(SteerablePoses, AreNoneInADeadEndTooNarrowToTurnIn) {
  // A slip 6 m wide leads north out of a basin; the boat turns in 10 m.
  const Area water = unite(rectangle(0, 0, 60, 40), rectangle(27, 39, 33, 120));
  const SteerablePoses poses(water, 5.0);
  EXPECT_TRUE(poses.steerable({30, 20}, {1, 0}));
  EXPECT_FALSE(poses.steerable({30, 80}, {0, 1}));
  EXPECT_FALSE(poses.steerable({30, 80}, {0, -1}));
  // With a second mouth it is sailed through.
  const SteerablePoses through(unite(water, rectangle(0, 118, 60, 160)), 5.0);
  EXPECT_TRUE(through.steerable({30, 80}, {0, 1}));
}

TEST(SteerablePoses, OfNoWaterAreNone) {
  EXPECT_FALSE(SteerablePoses({}, 5.0).steerable({0, 0}, {0, 1}));
}

/// The cells of a level floor that nothing has sounded, as far as a boat in `water` can see them.
OutOfReach left_out(const Area& water, double turn_radius_m, double position_error_m) {
  TestGround site(flat(60, 60, 4), Nodata::open, rectangle(0, 0, 60, 60));
  site.ground.water = water;
  Vehicle vehicle;
  vehicle.draft_m = 0.5;
  vehicle.turn_radius_m = turn_radius_m;
  vehicle.position_error_m = position_error_m;
  Sonar sonar = *sonar_preset("em2040");
  sonar.max_opening = Angle::degrees(90);
  std::vector<JudgedGrid> grids = criterion_grids(criterion("s44-1a"), site.ground);
  return ReachSearch(site.ground, sonar, vehicle).leave_out(grids);
}

TEST(OutOfReach, HidesWhatLiesFartherThanTheFanReaches) {
  // From water up to x = 20 a fan of 45 degrees over 3.5 m sees cells up to x = 23.5.
  const OutOfReach out = left_out(rectangle(0, 0, 20, 60), 2.0, 0.0);
  EXPECT_NEAR(out.hidden_m2, 60.0 * 36.5, 60.0);
  EXPECT_LE(out.unsteerable_m2, 60.0);  // the lattice may lose the row at the edge
}

TEST(OutOfReach, LeavesOutWhatAsksForABetterHelmsman) {
  const OutOfReach out = left_out(rectangle(0, 0, 20, 60), 2.0, 1.5);
  EXPECT_NEAR(out.hidden_m2, 60.0 * 36.5, 60.0);
  EXPECT_NEAR(out.unsteerable_m2, 60.0 * 1.5, 75.0);
  EXPECT_GT(out.unsteerable_m2, 30.0);
}

TEST(OutOfReach, LeavesOutWaterTooNarrowToTurnIn) {
  const OutOfReach out = left_out(rectangle(26, 0, 34, 60), 6.0, 0.0);
  EXPECT_GT(out.unsteerable_m2, 60.0 * 8.0);
  EXPECT_NEAR(out.total_m2(), 3600.0, 1e-6);
}

}  // namespace
}  // namespace swathplan

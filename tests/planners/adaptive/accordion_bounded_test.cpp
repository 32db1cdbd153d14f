#include <gtest/gtest.h>

#include "planners/adaptive/accordion_bounded_internal.h"

namespace swathplan {
namespace {

/// Eight strips of 50 m.
AccordionState bounded_state(double length_m) {
  AccordionOptions options;
  options.width_m = 400.0;
  options.length_m = length_m;
  options.spacing_m = 50.0;
  options.rule = AccordionRule::bounded;
  return start_accordion(options);
}

/// After one track at 50 m that saw `strips` strips, `with_objects` of them with an object.
AccordionState after_one_track(int strips, int with_objects) {
  AccordionState state = bounded_state(400.0);
  state.sailed.push_back({0, 50.0, true});
  state.front_m = 50.0;
  state.sailed_m = 450.0;
  state.seen_from_above.add({0.0, 50.0});
  state.seen_from_below.add({50.0, 100.0});
  state.strips_seen = strips;
  state.strips_with_objects = with_objects;
  return state;
}

// A start one strip in costs at worst 500 m + 9 tracks. The bound is 450 m + 10 tracks.
TEST(AccordionBounded, StartsOneStripInOnceATrackIsAsLongAsAStripIsWide) {
  EXPECT_EQ(bounded_start(bounded_state(49.0)), 0.0);
  EXPECT_EQ(bounded_start(bounded_state(51.0)), 50.0);
  EXPECT_EQ(bounded_start(bounded_state(400.0)), 50.0);
}

TEST(AccordionBounded, SkipsAStripWhileObjectsAreRare) {
  EXPECT_EQ(bounded_step(after_one_track(1, 0)), 150.0);
  EXPECT_EQ(bounded_step(after_one_track(20, 20)), 100.0);
}

TEST(AccordionBounded, NeverSkipsBeyondTheFarLookAtAnObjectAhead) {
  AccordionState state = after_one_track(1, 0);
  state.pending.push_back({80.0, 80.0});
  // From 130 m the object is at the end of the sonar's range.
  EXPECT_EQ(bounded_step(state), 130.0);
}

TEST(AccordionBounded, GoesBackToTheNearEdgeOfAnObjectBehind) {
  AccordionState state = after_one_track(1, 0);
  EXPECT_FALSE(bounded_loop_back(state).has_value());
  state.sailed.push_back({1, 150.0, false});
  state.front_m = 150.0;
  state.sailed_m = 950.0;
  state.seen_from_above.add({100.0, 150.0});
  state.pending.push_back({120.0, 120.0});
  ASSERT_TRUE(bounded_loop_back(state).has_value());
  EXPECT_EQ(*bounded_loop_back(state), 120.0);
  state.seen_from_below.add({100.0, 150.0});
  EXPECT_FALSE(bounded_loop_back(state).has_value());
}

}  // namespace
}  // namespace swathplan

#include "coverage/route/vehicle.h"

#include <gtest/gtest.h>

#include <set>

namespace swathplan {
namespace {

TEST(Vehicle, PresetsAreFoundByTheirOwnNamesAndCanSail) {
  std::set<std::string> names;
  for (const Vehicle& preset : vehicle_presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    const auto found = vehicle_preset(preset.name);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->turn_radius_m, preset.turn_radius_m);
    EXPECT_GT(preset.speed_mps, 0.0);
    EXPECT_GT(preset.turn_speed_mps, 0.0);
    EXPECT_GT(preset.transit_speed_mps, 0.0);
    EXPECT_GT(preset.turn_radius_m, 0.0);
    EXPECT_GT(preset.endurance_h, 0.0);
  }
  EXPECT_FALSE(vehicle_preset("submarine").has_value());
}

TEST(Vehicle, TheDefaultIsTheFirstPreset) {
  const Vehicle usual;
  EXPECT_EQ(vehicle_presets().front().name, usual.name);
  EXPECT_EQ(vehicle_presets().front().draft_m, usual.draft_m);
}

TEST(Vehicle, SafeDepthIsDraftSquatAndMargin) {
  const Vehicle vehicle{.draft_m = 1.0, .under_keel_margin_m = 0.25, .squat_m = 0.5};
  EXPECT_DOUBLE_EQ(safe_depth_m(vehicle), 1.75);
  EXPECT_DOUBLE_EQ(safe_depth_m({.draft_m = 0.0, .under_keel_margin_m = 0.0}), 0.0);
}

}  // namespace
}  // namespace swathplan

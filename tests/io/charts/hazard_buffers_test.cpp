#include "io/charts/hazard_buffers.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(HazardBuffers, GrowWithTheStatedAccuracy) {
  const auto metres = [](std::optional<double> posacc, std::optional<int> quapos,
                         std::optional<int> catzoc) {
    return position_accuracy({posacc, quapos, catzoc, 10'000}, true).metres;
  };
  EXPECT_DOUBLE_EQ(metres({}, {}, {}), 3.0);  // 0.3 mm at the scale
  EXPECT_DOUBLE_EQ(metres({}, 1, 1), 10.0);
  EXPECT_DOUBLE_EQ(metres({}, 4, 2), 30.5);
  EXPECT_DOUBLE_EQ(metres({}, 4, 3), 50.0);
  EXPECT_DOUBLE_EQ(metres({}, 5, 3), 200.0);
  EXPECT_DOUBLE_EQ(metres({}, 5, 4), 500.0);
  EXPECT_DOUBLE_EQ(metres(12.0, 5, 4), 12.0);  // a figure in metres goes before the words
}

TEST(HazardBuffers, OnlyDangersUnderWaterShareTheQualityOfTheSoundings) {
  const StatedPosition stated{{}, {}, 4, 80'000};
  const PositionAccuracy land = position_accuracy(stated, false);
  EXPECT_DOUBLE_EQ(land.metres, 24.0);
  EXPECT_EQ(land.from, "scale 1:80000");
  EXPECT_EQ(position_accuracy(stated, true).from, "CATZOC C");
}

TEST(HazardBuffers, WithoutAnyStatementSomeRoomIsKept) {
  const PositionAccuracy none = position_accuracy({}, true);
  EXPECT_DOUBLE_EQ(none.metres, 50.0);
  EXPECT_EQ(none.from, "nothing");
}

TEST(HazardBuffers, WrecksAreToBeSeenAndLandIsNot) {
  EXPECT_TRUE(hazard_class("wrecks")->to_be_seen);
  EXPECT_FALSE(hazard_class("LNDARE")->to_be_seen);
  EXPECT_EQ(hazard_class("DEPARE"), nullptr);
}

}  // namespace
}  // namespace swathplan

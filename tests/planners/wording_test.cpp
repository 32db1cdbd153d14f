#include "planners/wording.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(Wording, CountsOneWithoutAnS) {
  EXPECT_EQ(counted(0, "turn"), "0 turns");
  EXPECT_EQ(counted(1, "turn"), "1 turn");
  EXPECT_EQ(counted(2, "turn"), "2 turns");
  EXPECT_EQ(counted(1, "infill pass", "infill passes"), "1 infill pass");
  EXPECT_EQ(counted(4, "infill pass", "infill passes"), "4 infill passes");
}

TEST(Wording, LinesSailedBothWaysPointFrom0To179) {
  EXPECT_EQ(axis_degrees(0.0), 0);
  EXPECT_EQ(axis_degrees(-8.0), 172);
  EXPECT_EQ(axis_degrees(-184.0), 176);
  EXPECT_EQ(axis_degrees(181.2), 1);
  EXPECT_EQ(axis_degrees(179.7), 0);
  EXPECT_EQ(axis_degrees(-0.3), 0);
}

TEST(Wording, AzimuthsAreTrueAndOfTheGridWhereTheseDiffer) {
  EXPECT_EQ(azimuth_text(90.2, 0.0), "90 degrees");
  EXPECT_EQ(azimuth_text(90.0, 2.84), "92.8 degrees true (90 of the grid)");
  EXPECT_EQ(azimuth_text(1.0, -2.0), "179 degrees true (1 of the grid)");
  EXPECT_EQ(azimuth_text(-4.0, 4.0), "0 degrees true (176 of the grid)");
}

}  // namespace
}  // namespace swathplan

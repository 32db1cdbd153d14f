#include <gtest/gtest.h>

#include "io/report/pictures_internal.h"
#include "mesh/seafloor.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

TEST(DepthPicture, FollowsTheSeafloor) {
  const Seafloor slope = tilted(100.0, 60.0, 5.0, Angle::degrees(20.0));
  const DepthQuery depths(slope);
  const internal::DepthPicture made = internal::depth_picture(
      internal::depth_field(depths, {.min = Vec2(-10.0, 0.0), .max = Vec2(90.0, 60.0)}, 100));
  EXPECT_EQ(made.picture.columns, 100U);
  EXPECT_EQ(made.picture.rows, 60U);
  const std::uint8_t* row = &made.picture.pixels[std::size_t{30} * 100];
  EXPECT_EQ(row[5], 0);  // west of the data
  for (int c = 11; c < 100; ++c) {
    EXPECT_GE((row[c] - 1) / internal::kDepthShades, (row[c - 1] - 1) / internal::kDepthShades);
  }
  EXPECT_EQ((row[99] - 1) / internal::kDepthShades, internal::kDepthLevels - 1);
}

TEST(SlopePicture, ShowsTheSlopeOfATiltedFloor) {
  const Seafloor slope = tilted(100.0, 60.0, 5.0, Angle::degrees(20.0));
  const DepthQuery depths(slope);
  const internal::SlopePicture made = internal::slope_picture(
      internal::depth_field(depths, {.min = Vec2(-10.0, 0.0), .max = Vec2(90.0, 60.0)}, 100));
  const std::uint8_t* row = &made.picture.pixels[std::size_t{30} * 100];
  EXPECT_EQ(row[5], 0);
  // At the border the slope is that to the one neighbour, no less.
  for (const int c : {10, 11, 50, 99}) {
    EXPECT_EQ(row[c], 1 + static_cast<int>(20.0 / internal::kSlopeStepDeg)) << c;
  }
  EXPECT_EQ(made.picture.palette.size(), 1U + internal::kSlopeLevels);
  EXPECT_TRUE(made.box.min.isApprox(Vec2(-10.0, 0.0)));
}

}  // namespace
}  // namespace swathplan

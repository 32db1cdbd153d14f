#include <gtest/gtest.h>

#include "io/report/pictures_internal.h"
#include "mesh/seafloor.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

TEST(DepthPicture, FollowsTheSeafloor) {
  const Seafloor slope = tilted(100.0, 60.0, 5.0, Angle::degrees(20.0));
  const DepthQuery depths(slope);
  const internal::DepthPicture made =
      internal::depth_picture(depths, {.min = Vec2(-10.0, 0.0), .max = Vec2(90.0, 60.0)}, 100);
  EXPECT_EQ(made.picture.columns, 100U);
  EXPECT_EQ(made.picture.rows, 60U);
  const std::uint8_t* row = &made.picture.pixels[std::size_t{30} * 100];
  EXPECT_EQ(row[5], 0);  // west of the data
  for (int c = 11; c < 100; ++c) {
    EXPECT_GE((row[c] - 1) / internal::kDepthShades, (row[c - 1] - 1) / internal::kDepthShades);
  }
  EXPECT_EQ((row[99] - 1) / internal::kDepthShades, internal::kDepthLevels - 1);
}

}  // namespace
}  // namespace swathplan

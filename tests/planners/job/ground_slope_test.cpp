#include "planners/job/ground_slope.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

TEST(GroundSlope, IsTheGradientOfATiltedFloor) {
  const Seafloor floor = tilted(200, 100, 10, Angle::degrees(15));
  const DepthQuery depths(floor);
  const auto slope = depth_gradient(depths, {100, 50}, 10.0);
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->norm(), std::tan(Angle::degrees(15).rad()), 2e-4) << "depths of whole mm";
  EXPECT_NEAR(slope->y(), 0.0, 1e-6);
}

TEST(GroundSlope, IsUnknownWhereOneOfTheDepthsIs) {
  const Seafloor floor = tilted(200, 100, 10, Angle::degrees(15));
  const DepthQuery depths(floor);
  EXPECT_FALSE(depth_gradient(depths, {3, 50}, 10.0));
  EXPECT_TRUE(depth_gradient(depths, {3, 50}, 4.0));
}

}  // namespace
}  // namespace swathplan

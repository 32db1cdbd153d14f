#include "io/files/lonlat.h"

#include <gtest/gtest.h>

#include "io/sample_plan.h"

namespace swathplan {
namespace {

TEST(LonLat, ThereAndBackIsTheSamePlace) {
  const LonLat conversion(test::utm_frame());
  ASSERT_TRUE(conversion.known());
  const std::vector<Vec2> local{{0.0, 0.0}, {150.0, -20.0}};
  const std::vector<Vec2> lonlat = conversion.from_local(local);
  // West of the zone's central meridian of 15 degrees, as the origin's easting is below 500 km.
  EXPECT_NEAR(lonlat[0].x(), 14.8, 0.1);
  EXPECT_NEAR(lonlat[0].y(), 55.1, 0.1);
  EXPECT_GT(lonlat[1].x(), lonlat[0].x());
  EXPECT_LT(lonlat[1].y(), lonlat[0].y());
  const std::vector<Vec2> back = conversion.to_local(lonlat);
  for (std::size_t i = 0; i < local.size(); ++i) EXPECT_LT((back[i] - local[i]).norm(), 1e-6);
}

TEST(LonLat, IsUnknownWithoutACrs) { EXPECT_FALSE(LonLat(Frame{}).known()); }

}  // namespace
}  // namespace swathplan

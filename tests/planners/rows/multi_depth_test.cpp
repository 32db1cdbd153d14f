#include "planners/rows/multi_depth.h"

#include <gtest/gtest.h>

#include <array>

#include "mesh/synthetic.h"
#include "planners/rows/wide_turns.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(MultiDepth, LinesKeepTheirRegionsAngle) {
  const TestSite site(shaft(), kSafeDepthM);
  const Plan plan = plan_multi_depth(site.ground, row_options(0.10, 2));
  ASSERT_EQ(plan.openings.size(), 2U);
  std::array<bool, 2> seen{};
  for (const Waypoint& w : plan.route.waypoints) {
    if (w.kind != LegKind::line) continue;
    ASSERT_TRUE(w.region && w.fan);
    seen[static_cast<std::size_t>(*w.region)] = true;
    EXPECT_NEAR((w.fan->port + w.fan->starboard).rad(),
                plan.openings[static_cast<std::size_t>(*w.region)].rad(), 1e-9);
  }
  EXPECT_TRUE(seen[0] && seen[1]);
}

TEST(MultiDepth, SkipsRowsToo) {
  const WideTurns wide;
  const Plan plan = plan_multi_depth(wide.site.ground, wide.how);
  EXPECT_NE(plan.notes.back().find("order of the least way"), std::string::npos);
}

}  // namespace
}  // namespace swathplan

#include "planners/nuc/mdnuc.h"

#include <gtest/gtest.h>

#include <set>

#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(PlanMdnuc, EachRegionIsSailedWithItsOwnOpening) {
  const TestSite site(stepped(100, 60, 10, 30), kSafeDepthM);
  const Plan plan = plan_mdnuc(site.ground, row_options(0.10, 2));
  EXPECT_FALSE(fault(plan.route)) << *fault(plan.route);
  ASSERT_EQ(plan.regions.regions.size(), 2U);
  ASSERT_EQ(plan.openings.size(), 2U);
  EXPECT_EQ(plan.gates.gates.size(), 1U);
  std::set<int> sailed;
  for (const Waypoint& w : plan.route.waypoints) {
    if (w.kind != LegKind::line || !w.region) continue;
    ASSERT_TRUE(w.fan);
    sailed.insert(*w.region);
    EXPECT_NEAR((w.fan->port + w.fan->starboard).rad(),
                plan.openings[static_cast<std::size_t>(*w.region)].rad(), 1e-9);
  }
  EXPECT_EQ(sailed, (std::set<int>{0, 1}));
  // The deeper region needs the narrower fan for the same width.
  const std::size_t deep =
      plan.regions.regions[0].mean_depth_m > plan.regions.regions[1].mean_depth_m ? 0 : 1;
  EXPECT_LT(plan.openings[deep], plan.openings[1 - deep]);
}

TEST(PlanMdnuc, BandsWithoutAFaceAreRefused) {
  const TestSite site(flat(60, 60, 10), kSafeDepthM);
  PlanOptions how = row_options(0.10, 1);
  how.bands.limits = {20.0};
  EXPECT_THROW(static_cast<void>(plan_mdnuc(site.ground, how)), UsageError);
}

}  // namespace
}  // namespace swathplan

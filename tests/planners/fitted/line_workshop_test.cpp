#include "planners/fitted/line_workshop.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"
#include "planners/test_site.h"

namespace swathplan {
namespace {

TEST(Workshop, ALineSailedBackwardsKeepsItsFansOnTheirGround) {
  std::vector<Waypoint> line(3);
  for (std::size_t i = 0; i < 3; ++i) line[i].position = {0.0, static_cast<double>(i)};
  line[0].fan = FanAngles{Angle::degrees(10.0), Angle::degrees(20.0)};
  line[1].fan = line[2].fan = FanAngles{Angle::degrees(30.0), Angle::degrees(40.0)};
  const auto back = backwards(line);
  EXPECT_EQ(back[0].position, line[2].position);
  EXPECT_EQ(*back[0].fan, (FanAngles{Angle::degrees(40.0), Angle::degrees(30.0)}));
  EXPECT_EQ(*back[1].fan, (FanAngles{Angle::degrees(20.0), Angle::degrees(10.0)}));
}

// The second line is long behind the first: the estimate adds what the turn costs.
TEST(Workshop, EstimatesTheTimeOfJoinsAsWellAsTheirLength) {
  TestSite site(flat(60.0, 40.0, 8.0));
  const RayScene scene(site.seafloor, Nodata::wall);
  site.ground.scene = &scene;
  PlanOptions options = row_options(0.25, 1);
  options.vehicle.speed_mps = options.vehicle.turn_speed_mps = options.vehicle.transit_speed_mps =
      2.0;
  const std::vector<SurveyCurve> lines{straight_curve({20.0, 5.0}, {20.0, 35.0}),
                                       straight_curve({40.0, 35.0}, {40.0, 5.0})};
  constexpr LineAnglesOptions kAngles{};
  const auto estimate = [&] {
    LineWorkshop shop(site.ground, options);
    return shop.estimate(lines, shop.width(1.0), kAngles, 1, "two lines");
  };
  const Outcome even = estimate();
  EXPECT_GT(even.length_m, 80.0) << "lines, the way between them and what turning adds";
  EXPECT_NEAR(even.duration_s, even.length_m / 2.0, 1e-6);
  // Half the speed in turns: the join, 20 m and more, takes twice as long.
  options.vehicle.turn_speed_mps = 1.0;
  const Outcome slow = estimate();
  EXPECT_DOUBLE_EQ(slow.length_m, even.length_m);
  EXPECT_NEAR(slow.duration_s - even.duration_s, (even.length_m - 60.0) / 2.0, 0.01);
}

}  // namespace
}  // namespace swathplan

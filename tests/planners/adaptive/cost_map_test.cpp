#include "planners/adaptive/cost_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/adaptive/accordion_scan.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

SideScanImage even_image() {
  SideScanImage image{200, 300, 0.1, 0.2, 2.0, {}, {}};
  image.port.assign(60000, 0.0F);
  for (std::size_t i = 0; i < image.port.size(); ++i) {
    image.port[i] = static_cast<float>(1.0 / (1.0 + static_cast<double>(i % 300)));
  }
  image.starboard = image.port;
  return image;
}

float largest(const CostMap& map, int from, int to) {
  float result = 0.0F;
  for (int r = 0; r < map.rows; ++r) {
    for (int c = from; c < to; ++c) {
      result = std::max(
          result, map.values[static_cast<std::size_t>(r) * static_cast<std::size_t>(map.columns) +
                             static_cast<std::size_t>(c)]);
    }
  }
  return result;
}

TEST(CostMap, AHighlightWithShadowStandsOut) {
  SideScanImage image = even_image();
  for (std::size_t r = 100; r < 106; ++r) {
    for (std::size_t c = 180; c < 188; ++c) image.starboard[r * 300 + c] *= 8.0F;
    for (std::size_t c = 188; c < 210; ++c) image.starboard[r * 300 + c] = 0.0F;
  }
  const auto costs = cost_maps(image, true, {});
  EXPECT_EQ(costs.back.rows, 8);
  EXPECT_GT(largest(costs.ahead, 175, 195), 1.0F);
  EXPECT_LT(largest(costs.ahead, 100, 150), 0.5F);
  EXPECT_LT(largest(costs.back, 60, 300), 0.5F);  // range alone is no object
  EXPECT_EQ(largest(costs.ahead, 0, 20), 0.0F);   // nadir gap
  const auto turned = cost_maps(image, false, {});
  EXPECT_EQ(turned.back.values, costs.ahead.values);
}

TEST(CostMap, SmallPatchesAreWiped) {
  SideScanImage image = even_image();
  image.port[100 * 300 + 200] *= 300.0F;
  CostMapOptions options;
  options.smallest_m2 = 0.0;
  EXPECT_GT(largest(cost_maps(image, true, options).back, 0, 300), options.threshold);
  options.smallest_m2 = 50.0;
  EXPECT_LE(largest(cost_maps(image, true, options).back, 0, 300), options.threshold);
}

TEST(CostMap, NadirHeightsFillTheMiddle) {
  AccordionObservation observation = cost_maps(even_image(), true, {});
  NadirHeights heights{200, 40, 0.1, 0.2, std::vector<float>(8000, -30.0F)};
  for (std::size_t r = 50; r < 55; ++r) {
    for (std::size_t c = 30; c < 36; ++c) heights.z[r * 40 + c] = -29.0F;  // 1.0 to 1.6 m starboard
  }
  fill_nadir(observation, heights, true, {});
  EXPECT_GT(largest(observation.ahead, 10, 16), 1.0F);
  EXPECT_LT(largest(observation.back, 0, 20), 0.5F);
}

TEST(CostMap, TheNadirGapIsBlindUntilItIsFilled) {
  AccordionObservation observation = cost_maps(even_image(), true, {});
  EXPECT_DOUBLE_EQ(observation.back.blind_m, 2.0);
  EXPECT_DOUBLE_EQ(observation.ahead.along_m, 40.0);
  const auto refusal = [&](const NadirHeights& heights) {
    return message_of<InvalidInput>([&] { fill_nadir(observation, heights, true, {}); });
  };
  EXPECT_THAT(refusal({100, 40, 0.1, 0.2, std::vector<float>(4000, -30.0F)}), HasSubstr("4 rows"));
  EXPECT_THAT(refusal({200, 41, 0.1, 0.2, std::vector<float>(8200, -30.0F)}), HasSubstr("even"));
  fill_nadir(observation, {200, 20, 0.1, 0.2, std::vector<float>(4000, -30.0F)}, true, {});
  EXPECT_DOUBLE_EQ(observation.back.blind_m, 2.0);  // looked at to 1 m only
  fill_nadir(observation, {200, 40, 0.1, 0.2, std::vector<float>(8000, -30.0F)}, true, {});
  EXPECT_DOUBLE_EQ(observation.back.blind_m, 0.0);
  EXPECT_DOUBLE_EQ(observation.ahead.blind_m, 0.0);
}

TEST(CostMap, RefusesBadImages) {
  try {
    (void)cost_maps(SideScanImage{}, true, {});
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), HasSubstr("0 x 0 pixels"));
  }
  SideScanImage image = even_image();
  image.starboard.pop_back();
  EXPECT_THROW((void)cost_maps(image, true, {}), InvalidInput);
  CostMapOptions options;
  options.window_m = 0.0;
  EXPECT_THROW((void)cost_maps(even_image(), true, options), UsageError);
}

// A whole mission: objects are found in images alone, and each is seen from both sides.
TEST(AccordionScan, EveryObjectIsSeenFromBothSides) {
  const Seafloor bottom = flat(230.0, 90.0, 25.0);
  const DepthQuery depths(bottom);
  ScanWorld world;
  world.box = {Vec2(15.0, 15.0), Angle::degrees(0), 200.0, 60.0, StartCorner::south_east};
  world.depth_below = [&](const Vec2& p) { return depths.depth(p).value_or(25.0); };
  const AccordionOptions options{
      .width_m = 200.0, .length_m = 60.0, .spacing_m = 40.0, .nadir_gap_m = 5.0, .threshold = 1.0};
  const auto objects = dropped_objects(world.box, 3, 8.0, depths, 5);
  const RayScene scene(with_objects(bottom, objects), Nodata::open);
  world.scene = &scene;
  int tracks = 0;
  const auto state = sail(options, world, [&](const ScannedTrack& t) {
    EXPECT_EQ(t.track.number, tracks++);
    EXPECT_EQ(t.image.columns, 450);
  });
  EXPECT_EQ(static_cast<int>(state.sailed.size()), tracks);
  for (const ObjectSights& seen : sights(objects, state.sailed, options, world)) {
    EXPECT_TRUE(seen.from_below && seen.from_above);
  }
}

TEST(AccordionScan, DroppedObjectsLieOnTheSeafloorInsideTheMargin) {
  const Seafloor bottom = tilted(100.0, 100.0, 10.0, Angle::degrees(5));
  const DepthQuery depths(bottom);
  const SurveyBox box{Vec2(10.0, 10.0), Angle::degrees(0), 80.0, 80.0};
  const auto objects = dropped_objects(box, 30, 10.0, depths, 2);
  ASSERT_EQ(objects.size(), 30U);
  for (const DroppedObject& o : objects) {
    EXPECT_GE(o.base.x(), 20.0);
    EXPECT_LE(o.base.y(), 80.0);
    EXPECT_NEAR(o.base.z(), -*depths.depth(o.base.head<2>()), 1e-9);
  }
  EXPECT_EQ(dropped_objects(box, 30, 10.0, depths, 2)[7].base, objects[7].base);
  const SurveyBox away{Vec2(500.0, 500.0), Angle::degrees(0), 80.0, 80.0};
  EXPECT_THROW((void)dropped_objects(away, 1, 10.0, depths, 2), InvalidInput);
  EXPECT_THROW((void)dropped_objects(box, 1, 40.0, depths, 2), InvalidInput);
}

}  // namespace
}  // namespace swathplan

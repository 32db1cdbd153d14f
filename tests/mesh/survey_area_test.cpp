#include "mesh/survey_area.h"

#include <gtest/gtest.h>

#include "mesh/base/error.h"
#include "mesh/shapes.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using test::box_area;

TEST(SurveyArea, OutlineOfAGridIsItsRectangle) {
  const Area area = outline(flat(80, 30, 5));
  ASSERT_EQ(area.size(), 1U);
  EXPECT_NEAR(area_m2(area), 2400, 1e-6);
  EXPECT_TRUE(area[0].holes.empty());
}

TEST(SurveyArea, HarbourKeepsItsIslandAsAHole) {
  const Area area = outline(harbour());
  ASSERT_EQ(area.size(), 1U);
  EXPECT_EQ(area[0].holes.size(), 1U);
  EXPECT_FALSE(contains(area, {232, 62})) << "the island";
  EXPECT_FALSE(contains(area, {50, 126})) << "the west mole";
  EXPECT_TRUE(contains(area, {155, 126})) << "the entrance";
}

TEST(SurveyArea, ShoalWaterIsCutAlongItsIsobath) {
  // Depth 2 + x tan(45): 5 m is reached at x = 3.
  const Seafloor floor = tilted(20, 10, 2.0, Angle::degrees(45));
  const Area area = survey_area(floor, {.limit = {}, .no_go = {}, .safe_depth_m = 5.0});
  EXPECT_NEAR(area_m2(area), 17 * 10, 0.02);
}

TEST(SurveyArea, ShoalGroundIsWhatTheSafeDepthTakes) {
  // Depth 2 + x tan(45): 5 m is reached at x = 3.
  const Seafloor floor = tilted(20, 10, 2.0, Angle::degrees(45));
  SurveyAreaOptions options{.limit = {}, .no_go = {}, .safe_depth_m = 5.0};
  EXPECT_NEAR(area_m2(shoal_ground(floor, options)), 3 * 10, 0.02);
  options.limit = box_area(1, 0, 20, 4);
  EXPECT_NEAR(area_m2(shoal_ground(floor, options)), 2 * 4, 0.02);
  options.no_go = box_area(0, 0, 2, 10);
  EXPECT_NEAR(area_m2(shoal_ground(floor, options)), 1 * 4, 0.02);
  options.safe_depth_m = 1.0;
  EXPECT_TRUE(shoal_ground(floor, options).empty()) << "all is deep enough";
  options.safe_depth_m = 0.0;
  EXPECT_TRUE(shoal_ground(floor, options).empty()) << "no safe depth, so nothing is too shoal";
}

TEST(SurveyArea, LandIsWhatLiesAboveTheLevel) {
  // Depth 2 + x tan(45): 5 m is reached at x = 3, so 3 m of ground lie above it.
  const Area land = above_level(tilted(20, 10, 2.0, Angle::degrees(45)), -5.0);
  EXPECT_NEAR(area_m2(land), 3 * 10, 0.02);
  EXPECT_TRUE(contains(land, {1, 5}));
  EXPECT_TRUE(above_level(flat(20, 10, 5), 0.0).empty());
}

TEST(SurveyArea, LimitAndNoGoApply) {
  const Seafloor floor = flat(100, 100, 10);
  const Area area = survey_area(
      floor,
      {.limit = box_area(-50, 0, 50, 50), .no_go = box_area(10, 10, 20, 20), .safe_depth_m = 1.0});
  EXPECT_NEAR(area_m2(area), 2500 - 100, 1e-6);
}

TEST(SurveyArea, SaysWhatTookTheLastOfIt) {
  const Seafloor floor = flat(100, 100, 10);
  const auto message = [&](const SurveyAreaOptions& options) -> std::string {
    try {
      static_cast<void>(survey_area(floor, options));
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message({.limit = {}, .no_go = {}, .safe_depth_m = 11}).find("draft"),
            std::string::npos);
  EXPECT_NE(
      message({.limit = box_area(500, 0, 600, 50), .no_go = {}, .safe_depth_m = 1}).find("CRS"),
      std::string::npos);
  EXPECT_NE(
      message({.limit = {}, .no_go = box_area(-1, -1, 101, 101), .safe_depth_m = 1}).find("no-go"),
      std::string::npos);
}

}  // namespace
}  // namespace swathplan

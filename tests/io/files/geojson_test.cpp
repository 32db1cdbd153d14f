#include "io/files/geojson.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/sample_plan.h"

namespace swathplan {
namespace {

TEST(GeoJson, SaysWhetherItsCoordinatesAreDegrees) {
  const Frame feet{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 0.3048, .crs_wkt = ""};
  const auto local = nlohmann::json::parse(geojson_head(feet) + geojson_tail());
  EXPECT_EQ(local.at("type"), "FeatureCollection");
  EXPECT_EQ(local.at("local_frame").at("unit_m"), 0.3048);
  EXPECT_TRUE(local.at("features").empty());
  EXPECT_EQ(geojson_name("route", feet), "route.local.geojson");
  const auto degrees = nlohmann::json::parse(geojson_head(test::utm_frame()) + geojson_tail());
  EXPECT_FALSE(degrees.contains("local_frame"));
  EXPECT_EQ(geojson_name("route", test::utm_frame()), "route.geojson");
}

TEST(GeoJson, PositionsAreThoseOfTheFileWithoutACrs) {
  const Frame feet{.origin = Vec2(1000.0, 2000.0), .metres_per_unit = 0.3048, .crs_wkt = ""};
  EXPECT_EQ(geojson_positions({Vec2(0.3048, -0.6096)}, feet).at(0), "[1001,1998]");
}

TEST(GeoJson, PositionsAreLongitudeThenLatitudeWithACrs) {
  const auto position =
      nlohmann::json::parse(geojson_positions({Vec2::Zero()}, test::utm_frame()).at(0));
  EXPECT_NEAR(position.at(0).get<double>(), 14.8, 0.1);
  EXPECT_NEAR(position.at(1).get<double>(), 55.1, 0.1);
}

}  // namespace
}  // namespace swathplan

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

TEST(GeoJson, LinesAreCutAt180Degrees) {
  const auto parts = cut_at_180({{179.0, 10.0}, {179.8, 10.0}, {-179.8, 14.0}, {-179.0, 14.0}});
  ASSERT_EQ(parts.size(), 2U);
  ASSERT_EQ(parts[0].size(), 3U);
  EXPECT_EQ(parts[0][2].lonlat, Vec2(180.0, 12.0));
  ASSERT_EQ(parts[1].size(), 3U);
  EXPECT_EQ(parts[1][0].lonlat, Vec2(-180.0, 12.0));
  EXPECT_EQ(parts[1][0].segment, 1U);
  EXPECT_EQ(parts[1][1].segment, 2U);
  EXPECT_EQ(cut_at_180({{-1.0, 0.0}, {1.0, 0.0}}).size(), 1U);
  // Places on the meridian itself belong to the side that the line is on.
  const auto touching = cut_at_180({{-179.0, 0.0}, {180.0, 0.0}});
  ASSERT_EQ(touching.size(), 1U);
  EXPECT_EQ(touching[0].back().lonlat, Vec2(-180.0, 0.0));
  const auto leaving = cut_at_180({{180.0, 0.0}, {-179.0, 0.0}, {-178.0, 0.0}});
  ASSERT_EQ(leaving.size(), 1U);
  EXPECT_EQ(leaving[0].front().lonlat, Vec2(-180.0, 0.0));
  const auto still = cut_at_180({{180.0, 0.0}, {-180.0, 1.0}});
  ASSERT_EQ(still.size(), 1U);
  EXPECT_EQ(still[0].size(), 2U);
}

TEST(GeoJson, RingsAreCutAt180Degrees) {
  const auto parts = ring_cut_at_180({{179.0, 0.0}, {-179.0, 0.0}, {-179.0, 2.0}, {179.0, 2.0}});
  ASSERT_EQ(parts.size(), 2U);
  for (const auto& ring : parts) {
    EXPECT_EQ(ring.size(), 4U);
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_DOUBLE_EQ(area, 2.0);
  }
  EXPECT_EQ(ring_cut_at_180({{1, 0}, {2, 0}, {2, 1}}).size(), 1U);
}

}  // namespace
}  // namespace swathplan

#include "io/files/crs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/base/angle.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

TEST(Crs, ReadsCodesAndSaysWhatTheyAre) {
  EXPECT_TRUE(is_projected(parse_crs("EPSG:32633")));
  EXPECT_FALSE(is_geographic(parse_crs("EPSG:32633")));
  EXPECT_TRUE(is_geographic(parse_crs("EPSG:4326")));
  EXPECT_FALSE(is_projected(parse_crs("EPSG:4326")));
  EXPECT_EQ(crs_name(parse_crs("EPSG:32633")), "EPSG:32633 (WGS 84 / UTM zone 33N)");
  EXPECT_EQ(crs_name(""), "none");
  EXPECT_EQ(parse_crs(parse_crs("EPSG:32633")), parse_crs("EPSG:32633"));
}

TEST(Crs, LeavesTheVerticalPartOut) {
  EXPECT_EQ(crs_name(parse_crs("EPSG:32633+5773")), "EPSG:32633 (WGS 84 / UTM zone 33N)");
}

TEST(Crs, KnowsFeet) {
  EXPECT_DOUBLE_EQ(metres_per_unit(parse_crs("EPSG:32633")), 1.0);
  EXPECT_NEAR(metres_per_unit(parse_crs("EPSG:2263")), 1200.0 / 3937.0, 1e-12);
  EXPECT_DOUBLE_EQ(metres_per_unit(""), 1.0);
}

TEST(Crs, RefusesWhatItCannotRead) {
  for (const char* text : {"", "EPSG:999999", "harbour", "EPSG:", "PROJCS[", "EPSG:5773"}) {
    EXPECT_THROW((void)parse_crs(text), UsageError) << text;
  }
}

TEST(Crs, TransformsThereAndBackInGisOrder) {
  const std::string utm = parse_crs("EPSG:32633");
  // 15 degrees east is the central meridian of zone 33: easting 500,000 at any latitude.
  const CrsTransform to_utm(wgs84_crs(), utm);
  EXPECT_NEAR(to_utm(Vec2(15.0, 55.0)).x(), 500000.0, 1e-6);
  EXPECT_NEAR(to_utm(Vec2(15.0, 0.0)).y(), 0.0, 1e-6);
  const CrsTransform to_lon_lat(utm, wgs84_crs());
  const Vec2 place(479670.0, 6104860.0);
  const Vec2 back = to_utm(to_lon_lat(place));
  EXPECT_NEAR((back - place).norm(), 0.0, 1e-5);
  EXPECT_NEAR(to_lon_lat(place).x(), 14.68, 0.01);
  EXPECT_NEAR(to_lon_lat(place).y(), 55.09, 0.01);
}

TEST(Crs, PlacesWithoutCounterpartAreRefused) {
  const CrsTransform to_utm(wgs84_crs(), parse_crs("EPSG:32633"));
  EXPECT_THROW((void)to_utm(Vec2(15.0, 5000.0)), InvalidInput);
}

TEST(Crs, PicksTheUtmZone) {
  EXPECT_THAT(crs_name(utm_crs(14.7, 55.1)), testing::HasSubstr("EPSG:32633"));
  EXPECT_THAT(crs_name(utm_crs(-93.7, 49.7)), testing::HasSubstr("EPSG:32615"));
  EXPECT_THAT(crs_name(utm_crs(151.2, -33.9)), testing::HasSubstr("EPSG:32756"));
  EXPECT_THAT(crs_name(utm_crs(-180.0, 1.0)), testing::HasSubstr("EPSG:32601"));
  EXPECT_THAT(crs_name(utm_crs(179.9, 1.0)), testing::HasSubstr("EPSG:32660"));
  EXPECT_THAT(crs_name(utm_crs(266.3, 49.7)), testing::HasSubstr("EPSG:32615"));
}

TEST(Crs, ConvergenceIsTheTrueAzimuthOfGridNorth) {
  // About tan(gamma) = tan(lon - lon0) sin(lat), east of the central meridian above 0.
  const std::string utm = utm_crs(15.0, 60.0);
  for (const double lon : {12.5, 15.0, 17.5}) {
    const Vec2 at = CrsTransform(wgs84_crs(), utm)(Vec2(lon, 60.0));
    const double expected = Angle::radians(std::atan(std::tan(Angle::degrees(lon - 15.0).rad()) *
                                                     std::sin(Angle::degrees(60.0).rad())))
                                .deg();
    EXPECT_NEAR(meridian_convergence_deg(utm, at), expected, 0.003) << lon;
  }
}

}  // namespace
}  // namespace swathplan

#include "io/seafloor/true_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/files/crs.h"

namespace swathplan {
namespace {

Box2 around_place(const std::string& crs, double lon, double lat, double reach) {
  const Vec2 middle = CrsTransform(wgs84_crs(), crs)(Vec2(lon, lat));
  return {middle.array() - reach, middle.array() + reach};
}

TEST(TrueScale, UtmAndFeetAreWhatTheySay) {
  const std::string utm = parse_crs("EPSG:32630");
  const MapScaleAtData metres = map_scale(utm, around_place(utm, -1.9, 43.3, 1000.0));
  EXPECT_EQ(metres.kind, MapScale::true_to_ground);
  EXPECT_EQ(metres.metres_per_unit, 1.0);
  const std::string feet = parse_crs("EPSG:2263");  // New York, US survey feet
  const MapScaleAtData ny = map_scale(feet, around_place(feet, -74.0, 40.7, 5000.0));
  EXPECT_EQ(ny.kind, MapScale::true_to_ground);
  EXPECT_NEAR(ny.metres_per_unit, 0.3048006096, 1e-9);
}

TEST(TrueScale, WebMercatorStretchesEvenly) {
  const std::string mercator = parse_crs("EPSG:3857");
  const double lat = 60.0;
  const MapScaleAtData scale = map_scale(mercator, around_place(mercator, 10.0, lat, 500.0));
  EXPECT_EQ(scale.kind, MapScale::even);
  // On the sphere a metre of the map is cos(latitude) metres; the ellipsoid adds up to 0.7 %.
  EXPECT_NEAR(scale.metres_per_unit, std::cos(lat * std::numbers::pi / 180.0), 0.004);
  const MapScaleAtData equator = map_scale(mercator, around_place(mercator, 10.0, 0.0, 500.0));
  EXPECT_EQ(equator.kind, MapScale::true_to_ground);
}

TEST(TrueScale, AnEquidistantMapIsUnevenAwayFromTheEquator) {
  const std::string plate = parse_crs("EPSG:4087");
  EXPECT_EQ(map_scale(plate, around_place(plate, 10.0, 60.0, 500.0)).kind, MapScale::uneven);
}

TEST(TrueScale, ALargeSheetInWebMercatorIsUneven) {
  const std::string mercator = parse_crs("EPSG:3857");
  EXPECT_EQ(map_scale(mercator, around_place(mercator, 10.0, 60.0, 2e5)).kind, MapScale::uneven);
}

}  // namespace
}  // namespace swathplan

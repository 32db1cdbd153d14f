#include "coverage/side_scan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coverage/dropped_objects.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"

namespace swathplan {
namespace {

constexpr double kDepth = 30.0;

SideScanImage image_of(const Seafloor& seafloor, const SideScanSonar& sonar) {
  const RayScene scene(seafloor, Nodata::open);
  return side_scan_image(
      scene, Vec2(100, 20), Vec2(100, 30), [](const Vec2&) { return kDepth; }, sonar);
}

SideScanSonar quiet() {
  SideScanSonar sonar;
  sonar.looks = 0.0;
  sonar.attenuation_db_per_m = 0.0;
  return sonar;
}

float at(const std::vector<float>& side, const SideScanImage& image, double along, double across) {
  const auto row = static_cast<std::size_t>(along / image.row_m);
  return side[row * static_cast<std::size_t>(image.columns) +
              static_cast<std::size_t>(across / image.pixel_m)];
}

// On a flat bottom the return is Lambert's: the square of the sine of the grazing angle.
TEST(SideScan, FlatBottomFollowsTheGrazingAngle) {
  const auto image = image_of(flat(200, 50, kDepth), quiet());
  EXPECT_EQ(image.rows, 50);
  EXPECT_EQ(image.columns, 500);
  for (const double y : {3.05, 10.05, 25.05, 45.05}) {
    const double sine2 = 36.0 / (36.0 + y * y);
    EXPECT_NEAR(at(image.port, image, 5.0, y), sine2, 0.02 * sine2) << y;
    EXPECT_NEAR(at(image.starboard, image, 5.0, y), sine2, 0.02 * sine2) << y;
  }
}

// A box of height h at distance y throws a shadow from its top's far edge to y H / (H - h).
TEST(SideScan, ShadowHasTheLengthOfGeometry) {
  const DroppedObject box{ObjectShape::box, Vec3(120, 25, -kDepth), 1.0, 3.0, Angle::degrees(0)};
  const auto image = image_of(with_objects(flat(200, 50, kDepth), {box}), quiet());
  const double shadow_end = 20.5 * 6.0 / 5.0;
  EXPECT_GT(at(image.starboard, image, 5.0, 19.0), 0.0F);
  EXPECT_EQ(at(image.starboard, image, 5.0, shadow_end - 0.3), 0.0F);
  EXPECT_EQ(at(image.starboard, image, 5.0, 21.5), 0.0F);
  EXPECT_GT(at(image.starboard, image, 5.0, shadow_end + 0.3), 0.0F);
  EXPECT_GT(at(image.starboard, image, 2.0, 21.5), 0.0F);  // beside the box
  EXPECT_GT(at(image.port, image, 5.0, 21.5), 0.0F);
  // Its lit face returns more than the bottom before it.
  float brightest = 0.0F;
  for (double y = 18.5; y < 20.5; y += 0.1) {
    brightest = std::max(brightest, at(image.starboard, image, 5.0, y));
  }
  EXPECT_GT(brightest, 5.0F * at(image.starboard, image, 5.0, 18.0));
}

TEST(SideScan, NadirGapHoldsNoData) {
  SideScanSonar sonar = quiet();
  sonar.nadir_gap_m = 4.0;
  const auto image = image_of(flat(200, 50, kDepth), sonar);
  EXPECT_EQ(at(image.port, image, 5.0, 3.9), 0.0F);
  EXPECT_GT(at(image.port, image, 5.0, 4.1), 0.0F);
}

TEST(SideScan, SpeckleHasItsLooksAndItsSeed) {
  SideScanSonar sonar = quiet();
  sonar.looks = 4.0;
  const Seafloor bottom = flat(200, 50, kDepth);
  const auto speckled = image_of(bottom, sonar);
  const auto plain = image_of(bottom, quiet());
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < plain.port.size(); ++i) {
    const double ratio = speckled.port[i] / plain.port[i];
    sum += ratio;
    squares += ratio * ratio;
  }
  const auto n = static_cast<double>(plain.port.size());
  EXPECT_NEAR(sum / n, 1.0, 0.02);
  EXPECT_NEAR(std::sqrt(squares / n - sum * sum / n / n), 0.5, 0.02);
  EXPECT_EQ(image_of(bottom, sonar).port, speckled.port);
  sonar.seed = 2;
  EXPECT_NE(image_of(bottom, sonar).port, speckled.port);
}

TEST(SideScan, NadirHeightsAreTheSeafloors) {
  const Seafloor bottom = tilted(200, 50, 20.0, Angle::degrees(3));
  const RayScene scene(bottom, Nodata::open);
  const auto depth = [](const Vec2& p) { return 20.0 + p.x() * std::tan(0.0523598776); };
  const auto heights = nadir_heights(scene, Vec2(100, 10), Vec2(100, 20), depth, 5.0, quiet());
  EXPECT_EQ(heights.columns, 100);
  EXPECT_NEAR(heights.z[50], -depth(Vec2(100.05, 0)), 0.02);
  EXPECT_LT(heights.z[99], heights.z[0]);  // starboard is east, where it is deeper
}

TEST(SideScan, KeepsItsAltitudeAndOutOfTheAir) {
  EXPECT_DOUBLE_EQ(sonar_height_m(30.0, {}), -24.0);
  EXPECT_DOUBLE_EQ(sonar_height_m(5.0, {}), -0.5);
  EXPECT_DOUBLE_EQ(sonar_height_m(0.6, {}), -0.1);
}

TEST(SideScan, RefusesBadSonars) {
  const auto refuses = [](auto change) {
    SideScanSonar sonar;
    change(sonar);
    EXPECT_THROW(check(sonar), UsageError);
  };
  refuses([](auto& s) { s.range_m = 0.0; });
  refuses([](auto& s) { s.pixel_m = -1.0; });
  refuses([](auto& s) { s.ping_spacing_m = 0.0; });
  refuses([](auto& s) { s.altitude_m = 0.1; });
  refuses([](auto& s) { s.nadir_gap_m = 50.0; });
  refuses([](auto& s) { s.rays_per_pixel = 0; });
  refuses([](auto& s) { s.attenuation_db_per_m = -1.0; });
  refuses([](auto& s) { s.looks = 0.5; });
}

}  // namespace
}  // namespace swathplan

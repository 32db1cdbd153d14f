#include "mesh/planar/face_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/base/error.h"
#include "mesh/shapes.h"

namespace swathplan {
namespace {

Area turned_box(double width, double height, Angle by) {
  Area area = test::box_area(0, 0, width, height);
  for (Vec2& p : area[0].outer) p = rotated(p, by);
  return area;
}

TEST(FaceLayout, TurnsTheMainDirectionAlongX) {
  for (const double degrees : {0.0, 10.0, 44.0, 80.0}) {
    const Area area = turned_box(200, 80, Angle::degrees(degrees));
    const FaceLayout layout = face_layout(area, 20.0, {});
    EXPECT_NEAR(layout.turned_by.deg(), degrees, 0.01);
    const Vec2 size = extent(layout.area).size();
    // The outline lies inside the given one by up to 2 % of the size at either side.
    EXPECT_NEAR(size.x(), 199.6, 0.41) << degrees;
    EXPECT_NEAR(size.y(), 79.6, 0.41) << degrees;
  }
}

TEST(FaceLayout, AGivenTurnComesOnTop) {
  const FaceLayout plain = face_layout(turned_box(200, 80, Angle::degrees(25)), 20.0, {});
  const FaceLayout more =
      face_layout(turned_box(200, 80, Angle::degrees(25)), 20.0, Angle::degrees(30));
  EXPECT_NEAR((more.turned_by - plain.turned_by).deg(), 30.0, 1e-9);
}

TEST(FaceLayout, StaysInsideTheAreaAndKeepsNearlyAllOfIt) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Area area = test::blob(30, -20, 100, seed);
    const FaceLayout layout = face_layout(area, 25.0, {});
    Area back = layout.area;
    for (Polygon& polygon : back) {
      for (Vec2& p : polygon.outer) p = rotated(p, layout.turned_by);
    }
    // Points on the outline move by the lattice of Boolean operations.
    EXPECT_LT(area_m2(subtract(back, offset(area, 0.01))), 1e-6);
    EXPECT_GT(area_m2(back), 0.98 * area_m2(area));
  }
}

TEST(FaceLayout, RotationIsCounterClockwiseAndKeepsLengths) {
  EXPECT_NEAR((rotated({1, 0}, Angle::degrees(90)) - Vec2(0, 1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(rotated({3, 4}, Angle::degrees(33)).norm(), 5.0, 1e-14);
}

TEST(FaceLayout, AFittedStepGoesIntoTheLengthAWholeNumberOfTimes) {
  EXPECT_DOUBLE_EQ(fitted_step(100.0, 30.0), 100.0 / 3.0);
  EXPECT_DOUBLE_EQ(fitted_step(10.0, 30.0), 10.0);
  for (const double length : {7.0, 55.5, 1234.0}) {
    const double times = length / fitted_step(length, 6.4);
    EXPECT_NEAR(times, std::round(times), 1e-9);
  }
}

TEST(FaceLayout, NothingToMeshIsRefused) {
  EXPECT_THROW(static_cast<void>(face_layout({}, 10.0, {})), InvalidInput);
  EXPECT_THROW(require_faces({}), InvalidInput);
  EXPECT_NO_THROW(require_faces({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}}));
}

}  // namespace
}  // namespace swathplan

#include "mesh/cropped.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

Seafloor two_squares() {
  Seafloor s;
  s.frame.origin = Vec2(5, 6);
  s.vertices = {{0, 0, -1}, {1, 0, -2}, {1, 1, -3}, {9, 0, -4}, {10, 0, -5}, {10, 1, -6}};
  s.faces = {{0, 1, 2}, {3, 4, 5}};
  return s;
}

TEST(Cropped, KeepsWholeFacesThatMeetTheBox) {
  const Seafloor part = cropped(two_squares(), {{9.5, -5}, {20, 5}});
  ASSERT_EQ(part.faces.size(), 1U);
  ASSERT_EQ(part.vertices.size(), 3U);
  EXPECT_EQ(part.vertices[0], Vec3(9, 0, -4));
  EXPECT_EQ(part.frame.origin, Vec2(5, 6));
}

TEST(Cropped, IsEmptyWhereNoFaceIs) {
  const Seafloor part = cropped(two_squares(), {{3, 3}, {4, 4}});
  EXPECT_TRUE(part.faces.empty());
  EXPECT_TRUE(part.vertices.empty());
}

}  // namespace
}  // namespace swathplan

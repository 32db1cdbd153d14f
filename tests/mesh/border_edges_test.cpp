#include "mesh/border_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/synthetic.h"

namespace swathplan {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Edge = std::array<std::uint32_t, 2>;

TEST(BorderEdges, RunWithTheDataOnTheirLeft) {
  const Seafloor s = tilted(50, 30, 5, Angle::degrees(3));
  double twice_area = 0.0;
  for (const Edge& e : border_edges(s)) {
    const Vec3& a = s.vertices[e[0]];
    const Vec3& b = s.vertices[e[1]];
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_NEAR(twice_area, 2.0 * 50.0 * 30.0, 1e-6);
}

TEST(BorderEdges, ComeByTheirLowerVertex) {
  const Seafloor s{{{0, 0, -5}, {9, 0, -5}, {9, 9, -5}, {0, 9, -5}}, {{0, 1, 2}, {0, 2, 3}}, {}};
  EXPECT_THAT(border_edges(s), ElementsAre(Edge{0, 1}, Edge{3, 0}, Edge{1, 2}, Edge{2, 3}));
}

TEST(BorderEdges, ASeamBetweenSplitVerticesIsNoBorder) {
  const Seafloor s{{{0, 0, -5}, {9, 0, -5}, {9, 9, -5}, {0, 0, -5}, {9, 9, -5}, {0, 9, -5}},
                   {{0, 1, 2}, {3, 4, 5}},
                   {}};
  EXPECT_THAT(border_edges(s), ElementsAre(Edge{0, 1}, Edge{1, 2}, Edge{5, 3}, Edge{4, 5}));
}

TEST(BorderEdges, AnEmptySeafloorHasNone) { EXPECT_THAT(border_edges({}), IsEmpty()); }

}  // namespace
}  // namespace swathplan

#include "planners/rows/route_stretches.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

Waypoint sailed_at(double x, LegKind kind, std::optional<int> line = {}) {
  Waypoint w;
  w.position = {x, 0.0};
  w.kind = kind;
  w.log = kind == LegKind::line;
  w.line = line;
  return w;
}

TEST(RouteStretches, ATurnAndATransitInARowAreOneJoin) {
  const Route route{{sailed_at(0, LegKind::line, 1), sailed_at(1, LegKind::line, 1),
                     sailed_at(2, LegKind::turn), sailed_at(3, LegKind::transit),
                     sailed_at(4, LegKind::line, 2), sailed_at(5, LegKind::end)}};
  const auto parts = stretches(route);
  ASSERT_EQ(parts.size(), 3U);
  // A line ends where its join begins.
  ASSERT_EQ(parts[0].points.size(), 3U);
  EXPECT_FALSE(parts[0].join);
  EXPECT_EQ(parts[0].points.back().position.x(), 2.0);
  EXPECT_EQ(parts[0].points.back().line, 1);
  // The join does not hold the place where the next line begins.
  ASSERT_EQ(parts[1].points.size(), 2U);
  EXPECT_TRUE(parts[1].join);
  EXPECT_EQ(parts[1].points.back().position.x(), 3.0);
  ASSERT_EQ(parts[2].points.size(), 2U);
  EXPECT_EQ(parts[2].points.back().position.x(), 5.0);
  EXPECT_EQ(parts[2].points.back().kind, LegKind::line);
}

TEST(RouteStretches, EachLegOfALineIsAStretchOfItsOwn) {
  const Route route{{sailed_at(0, LegKind::run_in, 1), sailed_at(1, LegKind::line, 1),
                     sailed_at(2, LegKind::run_out, 1), sailed_at(3, LegKind::end)}};
  const auto parts = stretches(route);
  ASSERT_EQ(parts.size(), 3U);
  for (const RouteStretch& part : parts) EXPECT_FALSE(part.join);
}

}  // namespace
}  // namespace swathplan

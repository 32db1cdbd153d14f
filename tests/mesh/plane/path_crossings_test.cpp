#include "mesh/plane/path_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swathplan {
namespace {

TEST(SelfCrossings, NoneInSimplePaths) {
  EXPECT_EQ(self_crossings({}), 0U);
  EXPECT_EQ(self_crossings({{0, 0}, {1, 0}}), 0U);
  EXPECT_EQ(self_crossings({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}), 0U);
  EXPECT_EQ(self_crossings({{0, 0}, {5, 0}, {5, 0}, {5, 1}, {0, 1}, {0, 2}, {5, 2}}), 0U);
}

TEST(SelfCrossings, EachCrossingCountsOnce) {
  EXPECT_EQ(self_crossings({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), 1U);
  // A pentagram crosses itself five times.
  std::vector<Vec2> star;
  for (int i = 0; i <= 5; ++i) {
    const double a = 2 * M_PI * 2 * i / 5;
    star.emplace_back(std::cos(a), std::sin(a));
  }
  EXPECT_EQ(self_crossings(star), 5U);
}

TEST(SelfCrossings, ACornerInsideASegmentCountsWhereThePathPassesThrough) {
  // The corner (2, 0) lies on the first segment.
  EXPECT_EQ(self_crossings({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {2, -2}}), 1U);
  EXPECT_EQ(self_crossings({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {1, 2}}), 0U);
}

TEST(SelfCrossings, ACornerOnACornerCountsWhereThePathPassesThrough) {
  EXPECT_EQ(self_crossings({{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, -1}}), 1U);
  EXPECT_EQ(self_crossings({{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 1}}), 0U);
  // The same with a bent corner, passing through its narrow and its wide side.
  EXPECT_EQ(self_crossings({{-1, 1}, {0, 0}, {1, 1}, {1, 3}, {0, 3}, {0, 0}, {0, -1}}), 1U);
  EXPECT_EQ(self_crossings({{-1, 1}, {0, 0}, {1, 1}, {2, 0}, {0, 0}, {-2, -1}}), 0U);
}

TEST(SelfCrossings, SailingBackOverAnEarlierSegmentCounts) {
  EXPECT_EQ(self_crossings({{0, 0}, {4, 0}, {4, 1}, {5, 0}, {6, 0}}), 0U);
  EXPECT_EQ(self_crossings({{0, 0}, {4, 0}, {5, 1}, {3, 0}, {1, 0}}), 1U);
  EXPECT_EQ(self_crossings({{0, 0}, {4, 0}, {4, 1}, {0, 1}, {0, 0}, {4, 0}}), 1U);
}

TEST(SelfCrossings, ExactWhereRoundingWouldGuess) {
  // A corner a last bit on either side of a long diagonal, far from the origin.
  const double x = 5000.1;
  const double up = std::nextafter(x, 1e9);
  const double down = std::nextafter(x, 0.0);
  EXPECT_EQ(
      self_crossings({{x - 7, x - 7}, {x + 9, x + 9}, {x + 9, x + 20}, {x, up}, {x - 3, x + 9}}),
      0U);
  EXPECT_EQ(
      self_crossings({{x - 7, x - 7}, {x + 9, x + 9}, {x + 9, x + 20}, {x, down}, {x - 3, x + 9}}),
      2U);
}

std::size_t proper_by_loop(const std::vector<Vec2>& p) {
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
    const double v = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    return v > 0 ? 1 : -1;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = i + 2; j + 1 < p.size(); ++j) {
      count += side(p[i], p[i + 1], p[j]) != side(p[i], p[i + 1], p[j + 1]) &&
               side(p[j], p[j + 1], p[i]) != side(p[j], p[j + 1], p[i + 1]);
    }
  }
  return count;
}

TEST(SelfCrossings, AgreeWithALoopOverAllPairs) {
  std::mt19937 random(21);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec2> path{{1000.0 * uniform(), 0}};
    for (int i = 0; i < 300; ++i) {
      const double step = i % 17 == 0 ? 60.0 : 3.0;
      path.push_back(path.back() + step * Vec2(uniform() - 0.5, uniform() - 0.5));
    }
    EXPECT_EQ(self_crossings(path), proper_by_loop(path)) << trial;
  }
}

}  // namespace
}  // namespace swathplan

#include "mesh/plane/path_thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace swathplan {
namespace {

double distance_to_path(const Vec2& p, const std::vector<Vec2>& path) {
  double nearest = (p - path.front()).norm();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 along = path[i] - path[i - 1];
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp((p - path[i - 1]).dot(along) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (p - path[i - 1] - t * along).norm());
  }
  return nearest;
}

/// The largest distance of points along `a`, vertices and quarters of segments, to the path `b`.
double largest_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double largest = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    for (int k = 0; k <= 4; ++k) {
      largest = std::max(largest, distance_to_path(a[i - 1] + 0.25 * k * (a[i] - a[i - 1]), b));
    }
  }
  return largest;
}

std::vector<Vec2> points_of(const std::vector<Vec2>& path, const ThinnedPath& thinned) {
  std::vector<Vec2> points;
  for (const std::size_t i : thinned.kept) points.push_back(path[i]);
  return points;
}

/// A path that wanders, turns back, stands still and runs straight.
std::vector<Vec2> random_path(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec2> path{{500000.0 * unit(random), 100.0}};
  double course = 0.0;
  const int count = 2 + static_cast<int>(150 * unit(random));
  for (int i = 1; i < count; ++i) {
    course += unit(random) < 0.1 ? 6.0 * unit(random) : 0.3 * (unit(random) - 0.5);
    const double step = unit(random) < 0.1 ? 0.0 : 2.0 * unit(random);
    path.push_back(path.back() + step * Vec2(std::sin(course), std::cos(course)));
  }
  return path;
}

TEST(ThinPath, StaysWithinTheToleranceAndSaysHowFar) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 48; ++trial) {
    const std::vector<Vec2> path = random_path(random);
    const double tolerance = 0.01 * std::pow(2.0, trial % 8);
    std::vector<bool> keep(path.size(), false);
    keep[path.size() / 2] = true;
    const ThinnedPath thinned = thin_path(path, keep, tolerance);
    ASSERT_LE(thinned.largest_distance_m, tolerance) << trial;
    ASSERT_TRUE(std::is_sorted(thinned.kept.begin(), thinned.kept.end())) << trial;
    ASSERT_EQ(thinned.kept.front(), 0U);
    ASSERT_EQ(thinned.kept.back(), path.size() - 1);
    ASSERT_TRUE(std::binary_search(thinned.kept.begin(), thinned.kept.end(), path.size() / 2));
    const std::vector<Vec2> rest = points_of(path, thinned);
    ASSERT_LE(largest_distance(path, rest), thinned.largest_distance_m + 1e-9) << trial;
    ASSERT_LE(largest_distance(rest, path), thinned.largest_distance_m + 1e-9) << trial;
  }
}

TEST(ThinPath, AnArcKeepsWhatItsSagittaAsksFor) {
  // A half circle of 10 m radius: chords of angle a stand off by r (1 - cos(a / 2)).
  std::vector<Vec2> arc;
  for (int i = 0; i <= 1024; ++i) {
    const double a = std::numbers::pi * i / 1024.0;
    arc.emplace_back(10.0 * std::cos(a), 10.0 * std::sin(a));
  }
  const ThinnedPath thinned = thin_path(arc, {}, 0.1);
  const double widest = 2.0 * std::acos(1.0 - 0.1 / 10.0);
  EXPECT_GE(thinned.kept.size(), std::ceil(std::numbers::pi / widest) + 1.0);
  EXPECT_LE(thinned.kept.size(), 2.0 * std::numbers::pi / widest + 1.0);
  EXPECT_GT(thinned.largest_distance_m, 0.02);
}

TEST(ThinPath, AStraightKeepsItsEndsAndAnOvershootStays) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 1500; ++i) line.emplace_back(0.1 * i, 0.05 * i);
  EXPECT_EQ(thin_path(line, {}, 0.001).kept, (std::vector<std::size_t>{0, 1500}));
  const std::vector<Vec2> beyond{{0, 0}, {12, 0}, {10, 0}};
  EXPECT_EQ(thin_path(beyond, {}, 0.1).kept.size(), 3U);
}

TEST(ThinPath, StraightsObeyTheRule) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 100; ++i) line.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.001);
  const auto ten = [](std::size_t first, std::size_t last) { return last - first <= 10; };
  for (const double height : {0.0, 1.0}) {
    for (Vec2& p : line) p.y() *= height;
    const ThinnedPath thinned = thin_path(line, {}, 0.1, ten);
    EXPECT_GE(thinned.kept.size(), 11U);
    EXPECT_LT(thinned.kept.size(), 60U);
    for (std::size_t i = 1; i < thinned.kept.size(); ++i) {
      EXPECT_LE(thinned.kept[i] - thinned.kept[i - 1], 10U);
    }
  }
  EXPECT_EQ(thin_path(line, {}, 0.1, [](auto, auto) { return false; }).kept.size(), line.size());
}

TEST(ThinPath, ShortPathsAreKeptWhole) {
  EXPECT_TRUE(thin_path({}, {}, 0.1).kept.empty());
  EXPECT_EQ(thin_path({{1, 1}}, {}, 0.1).kept.size(), 1U);
  EXPECT_EQ(thin_path({{1, 1}, {1, 1}}, {}, 0.1).kept.size(), 2U);
}

TEST(ThinPath, LongCoilsAreQuick) {
  std::vector<Vec2> coil;
  for (int i = 0; i < 200000; ++i) coil.emplace_back(std::sin(0.1 * i), std::cos(0.1 * i));
  EXPECT_LT(thin_path(coil, {}, 0.01).kept.size(), coil.size());
}

}  // namespace
}  // namespace swathplan

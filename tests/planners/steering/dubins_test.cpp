#include "planners/steering/dubins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace swathplan {
namespace {

constexpr double kPi = std::numbers::pi;

Pose pose(double x, double y, double angle) { return {{x, y}, {std::cos(angle), std::sin(angle)}}; }

double miss(const DubinsPath& path, const Pose& to) {
  const Pose end = path.at(path.length_m());
  return (end.position - to.position).norm() + (end.course - to.course).norm();
}

TEST(Dubins, EveryWordEndsAtTheGoalAndTheFirstIsShortest) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-6.0, 6.0);
  for (int i = 0; i < 5000; ++i) {
    const Pose from = pose(any(random), any(random), any(random));
    const Pose to = pose(any(random), any(random), any(random));
    const auto paths = dubins_paths(from, to, 1.5);
    ASSERT_FALSE(paths.empty());
    for (const DubinsPath& path : paths) {
      ASSERT_LT(miss(path, to), 1e-9);
      ASSERT_GE(path.length_m(), paths.front().length_m());
    }
    ASSERT_GE(paths.front().length_m(), (to.position - from.position).norm() - 1e-12);
  }
}

TEST(Dubins, KnowsClosedForms) {
  const double r = 2.0;
  EXPECT_NEAR(dubins_length_m(pose(0, 0, 0), pose(10, 0, 0), r), 10.0, 1e-9);
  // A U-turn between rows 2R apart is half a circle; wider, a straight more.
  EXPECT_NEAR(dubins_length_m(pose(0, 0, 0), pose(0, 4, kPi), r), kPi * r, 1e-9);
  EXPECT_NEAR(dubins_length_m(pose(0, 0, 0), pose(0, 10, kPi), r), kPi * r + 6.0, 1e-9);
  // On the spot: three turns of 60, 300 and 60 degrees.
  EXPECT_NEAR(dubins_length_m(pose(0, 0, 0), pose(0, 0, kPi), r), 7.0 * kPi * r / 3.0, 1e-9);
  EXPECT_NEAR(dubins_length_m(pose(3, 4, 1), pose(3, 4, 1), r), 0.0, 1e-9);
}

TEST(Dubins, PathsReversedAreAsLong) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-9.0, 9.0);
  for (int i = 0; i < 1000; ++i) {
    const Pose a = pose(any(random), any(random), any(random));
    const Pose b = pose(any(random), any(random), any(random));
    const double back = dubins_length_m({b.position, -b.course}, {a.position, -a.course}, 1.0);
    ASSERT_NEAR(dubins_length_m(a, b, 1.0), back, 1e-9);
  }
}

TEST(Dubins, NoShorterPathIsFoundByTryingControls) {
  // Any bang-bang path of three pieces that happens to end near a pose is no shorter than the path
  // to where it ends.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> piece(0.0, 4.0);
  std::uniform_int_distribution<int> turn(-1, 1);
  const Pose from = pose(1.0, 2.0, 0.5);
  for (int i = 0; i < 3000; ++i) {
    const DubinsPath path(from, 1.5, {turn(random), turn(random), turn(random)},
                          {piece(random), piece(random), piece(random)});
    ASSERT_LE(dubins_length_m(from, path.at(path.length_m()), 1.5), path.length_m() + 1e-6);
  }
}

TEST(Dubins, PointsAreEvenAndBendNoTighterThanTheRadius) {
  const auto points = dubins_paths(pose(0, 0, 0), pose(0, 1, kPi), 2.0).front().points(0.1);
  const double step = (points[1] - points[0]).norm();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 in = points[i] - points[i - 1];
    const Vec2 out = points[i + 1] - points[i];
    const double bend = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
    EXPECT_LE(bend, 0.1 / 2.0 + 1e-9);
    EXPECT_NEAR(in.norm(), step, 1e-3);
  }
}

}  // namespace
}  // namespace swathplan

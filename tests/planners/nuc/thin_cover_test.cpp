#include "planners/nuc/thin_cover.h"

#include <gtest/gtest.h>

#include "mesh/synthetic.h"

namespace swathplan {
namespace {

constexpr double kDepth = 12.0;

/// Flat ground of 60 x 60 m and a line along it, off the middle.
struct FlatGround {
  Seafloor seafloor = flat(60.0, 60.0, kDepth);
  DepthQuery depths{seafloor};
  PlanOptions options;
  ThinCover cover{depths, {{{{0, 0}, {60, 0}, {60, 60}, {0, 60}}, {}}}, options};
  std::vector<Vec2> line;

  explicit FlatGround(double y) {
    for (double x = 5.13; x < 55.0; x += 1.6) line.emplace_back(x, y);
  }
  [[nodiscard]] ThinCover::Pull pull(const std::vector<Vec2>& points) const {
    return cover.pull(points,
                      std::vector<FanAngles>(points.size(), fan_for_depth(options, kDepth)));
  }
};

TEST(ThinCover, PullIsTheSlopeOfWhatIsEmpty) {
  const FlatGround ground(21.37);
  const auto exact = ground.pull(ground.line).down;
  constexpr double kStep = 1e-4;
  for (const std::size_t i : {5U, 11U, 20U}) {
    auto moved = ground.line;
    moved[i].y() += kStep;
    const double above = ground.pull(moved).empty_m2;
    moved[i].y() -= 2.0 * kStep;
    const double below = ground.pull(moved).empty_m2;
    const double slope = (above - below) / (2.0 * kStep);
    EXPECT_NEAR(exact[i].y(), -slope, 0.02 * std::abs(slope) + 1e-4);
  }
}

TEST(ThinCover, EmptyIsTheWholeAreaFarFromThePathAndLessBelowIt) {
  const FlatGround ground(30.0);
  const double covered = ground.pull(ground.line).empty_m2;
  EXPECT_LT(covered, 3600.0 - 600.0);
  EXPECT_GT(covered, 3600.0 - 1500.0);
  EXPECT_EQ(ground.pull({{1, 1}, {2, 2}}).empty_m2, 0.0) << "no course, nothing to say";
}

TEST(ThinCover, PassesArePulledToTheEmptySide) {
  FlatGround ground(27.0);
  const std::size_t n = ground.line.size();
  for (std::size_t i = n; i-- > 0;) ground.line.emplace_back(ground.line[i].x(), 33.0);
  const auto down = ground.pull(ground.line).down;
  EXPECT_LT(down[n / 2].y(), 0.0);
  EXPECT_GT(down[n + n / 2].y(), 0.0);
}

}  // namespace
}  // namespace swathplan

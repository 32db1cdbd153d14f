#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "planners/smoothing/path_relaxation_internal.h"

namespace swathplan {
namespace {

TEST(PathRelaxation, KeepsStraightLinesAndEndsAndClamps) {
  const std::vector<Vec2> line{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}};
  const PathRelaxation relaxation(line.size(), 3.0, 0.2);
  const std::vector<double> room(line.size(), 0.25);
  const auto same = relaxation.relaxed(line, line, room);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_LT((same[i] - line[i]).norm(), 1e-6);
  auto wanted = line;
  for (Vec2& p : wanted) p.y() += 2.0;
  const auto moved = relaxation.relaxed(wanted, line, room);
  EXPECT_EQ(moved.front(), line.front());
  EXPECT_EQ(moved[2].y(), 0.25);
}

}  // namespace
}  // namespace swathplan

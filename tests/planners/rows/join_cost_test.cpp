#include <gtest/gtest.h>

#include <cmath>

#include "planners/rows/line_order.h"

namespace swathplan {
namespace {

TEST(JoinCost, GoesRoundWhatLiesBetween) {
  // A wall from the south up to y = 80.
  const Area water{{{{0.0, 0.0},
                     {49.0, 0.0},
                     {49.0, 80.0},
                     {51.0, 80.0},
                     {51.0, 0.0},
                     {100.0, 0.0},
                     {100.0, 100.0},
                     {0.0, 100.0}},
                    {}}};
  const JoinCost cost(water, 2.0);
  EXPECT_DOUBLE_EQ(cost.way({10.0, 10.0}, {40.0, 10.0}), 30.0);
  const double round = 2.0 * std::hypot(9.0, 70.0) + 2.0;
  EXPECT_NEAR(cost.way({40.0, 10.0}, {60.0, 10.0}), round, 0.1 * round);
}

}  // namespace
}  // namespace swathplan

#include "io/pictures/scale_bar.h"

#include <gtest/gtest.h>

namespace swathplan {
namespace {

TEST(ScaleBar, LengthIsTheLargestRoundOneThatFits) {
  EXPECT_DOUBLE_EQ(round_length(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_length(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_length(4.99), 2.0);
  EXPECT_DOUBLE_EQ(round_length(99.0), 50.0);
  EXPECT_DOUBLE_EQ(round_length(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_length(2300.0), 2000.0);
}

}  // namespace
}  // namespace swathplan

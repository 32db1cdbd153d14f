#include "io/grids/no_data_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace swathplan {
namespace {

using testing::HasSubstr;

TEST(NoDataValues, SignsAreStrongWhereNoDepthIsLikely) {
  for (const double strong : {-9999.0, 999.9, -99.99, 99999.0, 32767.0, -32768.0, 1e6, -3.4e38}) {
    EXPECT_EQ(no_data_sign(strong), NoDataSign::strong) << strong;
  }
  EXPECT_EQ(no_data_sign(static_cast<double>(-999.9F)), NoDataSign::strong) << "32-bit floats";
  for (const double weak : {0.0, -1.0, 99.0, -9.9}) {
    EXPECT_EQ(no_data_sign(weak), NoDataSign::weak) << weak;
  }
  for (const double depth :
       {-8.2, 1.0, 9.0, 998.0, 12.99, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(no_data_sign(depth), NoDataSign::none) << depth;
  }
}

TEST(NoDataValues, DistanceAndFrequencyDecide) {
  const SuspectValue far{-999.9, 1, 100, -12.0, -8.0};
  EXPECT_TRUE(is_no_data(far));
  EXPECT_THAT(no_data_warning(far, "cells"), HasSubstr("1 of 100 cells hold -999.9"));
  const SuspectValue near{-999.9, 2, 100, -950.0, -8.0};
  EXPECT_FALSE(is_no_data(near));
  EXPECT_TRUE(is_worth_a_word(near));
  const SuspectValue zeros{0.0, 2, 100, -12.0, -8.0};
  EXPECT_FALSE(is_no_data(zeros));
  EXPECT_TRUE(is_worth_a_word(zeros));
  EXPECT_THAT(no_data_warning(zeros, "soundings"), HasSubstr("set <nodata value> 0"));
  EXPECT_FALSE(is_worth_a_word({0.0, 1, 100, -12.0, -8.0})) << "one in a hundred is rare";
  EXPECT_FALSE(is_worth_a_word({0.0, 50, 100, -12.0, -0.5})) << "a beach";
}

}  // namespace
}  // namespace swathplan

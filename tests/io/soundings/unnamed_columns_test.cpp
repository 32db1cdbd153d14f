#include "io/soundings/unnamed_columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace swathplan {
namespace {

using testing::HasSubstr;

UnnamedColumns columns_of(const std::vector<std::string_view>& rows) {
  UnnamedColumns columns;
  for (const std::string_view row : rows) columns.add(split_row(row, ' '), {});
  return columns;
}

TEST(UnnamedColumns, XyzWithMoreBehindIsClear) {
  EXPECT_EQ(columns_of({"0 0 -5 9", "1 0 -6 9", "0 1 -7 9", "1 1 -7 9"}).doubt(), "");
  EXPECT_EQ(columns_of({"500000.5 4000000 -5 a", "500010 4000000.5 -6 a"}).doubt(), "");
}

TEST(UnnamedColumns, WhatSpeaksAgainstXyzIsSaid) {
  EXPECT_THAT(columns_of({"1 40 50 -8", "2 41 50 -8", "3 40 51 -7"}).doubt(),
              HasSubstr("numbers of points"));
  EXPECT_THAT(columns_of({"a 40 50 -8", "b 41 50 -8"}).doubt(), HasSubstr("column 1"));
  EXPECT_THAT(columns_of({"9 4000000 500000 -8", "9 4000010 500000 -8"}).doubt(),
              HasSubstr("too large"));
}

TEST(UnnamedColumns, MatrixIsNoSoundings) {
  EXPECT_TRUE(columns_of({"-5 -5.1 -5.2 -5.3", "-5.5 -5.6 -5.7 -5.8"}).is_matrix());
  EXPECT_FALSE(columns_of({"500000 4000000 -8 1", "500010 4000000 -8 1"}).is_matrix());
}

}  // namespace
}  // namespace swathplan

#include "io/files/text_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace swathplan {
namespace {

TEST(TextFields, NumbersAreWholeFields) {
  EXPECT_EQ(to_number("4797000.456"), 4797000.456);
  EXPECT_EQ(to_number("+1.5e-3"), 1.5e-3);
  EXPECT_TRUE(std::isnan(*to_number("nan")));
  for (const char* text : {"", "1.2x", "x", "1,5", "--1", "1 2"}) {
    EXPECT_FALSE(to_number(text)) << text;
  }
}

TEST(TextFields, SplitsAtBlanksOrSeparators) {
  EXPECT_THAT(split("  1\t2   3\r", ' '), testing::ElementsAre("1", "2", "3"));
  EXPECT_THAT(split("1, \"two\" ,,4", ','), testing::ElementsAre("1", "two", "", "4"));
  EXPECT_THAT(split("", ' '), testing::IsEmpty());
  EXPECT_THAT(split("a;", ';'), testing::ElementsAre("a", ""));
}

TEST(TextFields, QuotesOnlyWhatPrints) {
  EXPECT_EQ(quotable("a\x01.\xff!"), "a?.?!");
  EXPECT_EQ(quotable("abcdef", 3), "abc...");
}

}  // namespace
}  // namespace swathplan

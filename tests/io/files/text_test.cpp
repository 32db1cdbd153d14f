#include "io/files/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

TEST(Text, NumbersAreWholeFields) {
  EXPECT_EQ(to_number("4797000.456"), 4797000.456);
  EXPECT_EQ(to_number("+1.5e-3"), 1.5e-3);
  EXPECT_TRUE(std::isnan(*to_number("nan")));
  for (const char* text : {"", "1.2x", "x", "1,5", "--1", "1 2"}) {
    EXPECT_FALSE(to_number(text)) << text;
  }
}

TEST(Text, NestingCountsBracketsOutsideOfTexts) {
  EXPECT_EQ(nesting_of_json("1"), 0U);
  EXPECT_EQ(nesting_of_json(R"({"a": [[1], [2]], "b": "[[[[["})"), 3U);
  EXPECT_EQ(nesting_of_json(R"({"\"[[[[": 1})"), 1U);
  EXPECT_EQ(nesting_of_json(std::string(100000, '[')), 100000U);
}

TEST(Text, ADeviceWithoutEndIsRefused) {
  try {
    (void)read_text("/dev/zero");
    FAIL() << "was read";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'/dev/zero' is no regular file"));
  }
}

TEST(Text, SplitsAtBlanksOrSeparators) {
  EXPECT_THAT(split("  1\t2   3\r", ' '), testing::ElementsAre("1", "2", "3"));
  EXPECT_THAT(split("1, \"two\" ,,4", ','), testing::ElementsAre("1", "two", "", "4"));
  EXPECT_THAT(split("", ' '), testing::IsEmpty());
  EXPECT_THAT(split("a;", ';'), testing::ElementsAre("a", ""));
}

TEST(Text, QuotesOnlyWhatPrints) {
  EXPECT_EQ(quotable("a\x01.\xff!"), "a?.?!");
  EXPECT_EQ(quotable("abcdef", 3), "abc...");
}

TEST(Text, FiniteNumbersMayHaveBlanksAroundThem) {
  EXPECT_EQ(to_finite_number(" 2.5\r\n"), 2.5);
  EXPECT_EQ(to_finite_number("+1e3"), 1000.0);
  for (const char* text : {"", " ", "nan", "inf", "-inf", "1 2", "1e999"}) {
    EXPECT_FALSE(to_finite_number(text)) << text;
  }
}

TEST(Text, DecimalsHaveNoTrailingZerosAndNoMinusZero) {
  EXPECT_EQ(decimal(1.5, 3), "1.5");
  EXPECT_EQ(decimal(2.0, 3), "2");
  EXPECT_EQ(decimal(-0.0004, 3), "0");
  EXPECT_EQ(decimal(0.0005, 2), "0");
  EXPECT_EQ(decimal(120.0, 0), "120");
  EXPECT_EQ(decimal(-0.25, 6), "-0.25");
}

TEST(Text, NumbersMayHaveTheExponentOfFortran) {
  EXPECT_EQ(to_number("0.5D+06"), 500000.0);
  EXPECT_EQ(to_number("-1.25d-1"), -0.125);
  EXPECT_EQ(to_number("1D"), std::nullopt);
  EXPECT_EQ(to_number("1D2D3"), std::nullopt);
  EXPECT_EQ(to_number("D3"), std::nullopt);
  EXPECT_EQ(to_number("1e2D3"), std::nullopt);
}

TEST(Text, TrimAndLowerLeaveTheMiddleAlone) {
  EXPECT_EQ(trim("\t a b \r\n"), "a b");
  EXPECT_EQ(trim(" \n"), "");
  EXPECT_EQ(lower("North-7 K\xC3\x98GE"), "north-7 k\xC3\x98ge");
}

TEST(Text, ReadsAFileAndRefusesWhatIsNoText) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.txt";
  const auto with = [&](std::string_view bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  };
  EXPECT_EQ(read_text(with(" x\r\n")), " x\r\n");
  EXPECT_THROW((void)read_text(with(" \n")), InvalidInput);
  EXPECT_THROW((void)read_text(with(std::string_view("a\0b", 3))), InvalidInput);
  EXPECT_THROW((void)read_text(folder.path()), InvalidInput);
  EXPECT_THROW((void)read_text(folder.path() / "missing"), InvalidInput);
}

}  // namespace
}  // namespace swathplan

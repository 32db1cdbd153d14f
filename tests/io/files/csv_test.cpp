#include "io/files/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace swathplan {
namespace {

using testing::ElementsAre;

TEST(Csv, ReadsHeaderRowsAndTheirLines) {
  const CsvTable table = parse_csv("\xEF\xBB\xBF X_m , Y\r\n1, 2\r\n\r\n3,4");
  EXPECT_THAT(table.header, ElementsAre("x_m", "y"));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_THAT(table.rows[0].fields, ElementsAre("1", "2"));
  EXPECT_EQ(table.rows[0].line, 2U);
  EXPECT_THAT(table.rows[1].fields, ElementsAre("3", "4"));
  EXPECT_EQ(table.rows[1].line, 4U);
}

TEST(Csv, TakesTheSeparatorOfTheFirstLine) {
  EXPECT_THAT(parse_csv("a;b\n1,5;2").rows.at(0).fields, ElementsAre("1,5", "2"));
  EXPECT_THAT(parse_csv("a\tb\n1;2\t3").rows.at(0).fields, ElementsAre("1;2", "3"));
  EXPECT_THAT(parse_csv("a,b\n1,2").rows.at(0).fields, ElementsAre("1", "2"));
}

TEST(Csv, QuotesKeepSeparatorsLinesAndQuotes) {
  const CsvTable table = parse_csv("a,b\n\"1,2\",\"say \"\"hi\"\"\"\n\"two\nlines\",3\n4,5\n");
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_THAT(table.rows[0].fields, ElementsAre("1,2", "say \"hi\""));
  EXPECT_THAT(table.rows[1].fields, ElementsAre("two\nlines", "3"));
  EXPECT_EQ(table.rows[2].line, 5U);
}

TEST(Csv, AnEmptyTextIsAnEmptyTable) {
  EXPECT_TRUE(parse_csv("").header.empty());
  EXPECT_TRUE(parse_csv("\n\n").rows.empty());
}

}  // namespace
}  // namespace swathplan

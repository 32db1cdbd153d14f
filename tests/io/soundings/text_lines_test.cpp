#include "io/soundings/text_lines.h"

#include "io/import_files.h"

namespace swathplan {
namespace {

using TextLinesFile = ImportFiles;

TEST_F(TextLinesFile, EndWithLineFeedsOrCarriageReturns) {
  for (const char* text : {"\xEF\xBB\xBF"
                           "a b\n\n c\n",
                           "a b\r\n\r\nc\r\n", "a b\r\rc"}) {
    TextLines lines(write("a.txt", text));
    std::string_view line;
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "a b");
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "");
    ASSERT_TRUE(lines.next(line));
    EXPECT_EQ(line, "c");
    EXPECT_EQ(lines.number(), 3U);
    EXPECT_FALSE(lines.next(line));
  }
}

}  // namespace
}  // namespace swathplan

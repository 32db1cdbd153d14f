#include "io/water/tide_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/water/times.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

class TideFile : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& text) const {
    std::ofstream(folder.path() / "tide.csv") << text;
    return folder.path() / "tide.csv";
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      (void)import_tide(file(text));
    } catch (const InvalidInput& e) {
      return e.what();
    }
    return "accepted";
  }
  test::TemporaryFolder folder;
};

TEST_F(TideFile, IsReadWithAHeaderOrWithout) {
  const char* const tables[] = {
      "time,height_m\n2026-05-01T06:00,0.5\n2026-05-01T07:00,1.5\n",
      "2026-05-01T06:00Z;0,5\n2026-05-01T07:00Z;1,5\n",
      "# gauge 3\nstation\tlevel\tdate\nA\t0.5\t2026-05-01 06:00\nA\t1.5\t2026-05-01 07:00\n"};
  for (const char* table : tables) {
    const ImportedTide read = import_tide(file(table));
    ASSERT_EQ(read.tide.rows().size(), 2U) << table;
    EXPECT_NEAR(*read.tide.height_m(*time_of("2026-05-01T06:30")), 1.0, 1e-9) << table;
    EXPECT_THAT(read.notes.at(0), HasSubstr("0.50 to 1.50 m"));
  }
}

TEST_F(TideFile, GapsAndDisorderAreNamedByTheirRows) {
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,1\n2026-05-01T05:00,1\n"),
              HasSubstr("line 3: 2026-05-01T05:00:00Z does not come after"));
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,1\n2026-05-01T06:00,1\n"),
              HasSubstr("sort the table by time"));
  EXPECT_THAT(
      refusal("2026-05-01T06:00,1\n2026-05-01T07:00,1\n2026-05-01T08:00,1\n"
              "2026-05-01T12:00,1\n"),
      HasSubstr("line 4: a gap of 4.0 h before 2026-05-01T12:00:00Z, where rows are 1.0 h"));
  EXPECT_THAT(refusal("2026-05-01T00:00,0.2\n2026-05-01T06:10,1.4\n2026-05-01T18:30,1.5\n"
                      "2026-05-02T00:40,0.2\n"),
              HasSubstr("line 3: rows so far apart are high and low waters in turn"));
  EXPECT_THAT(refusal("2026-05-01T00:00,0.2\n2026-05-01T06:10,-140\n"),
              HasSubstr("line 2: no tide stands at -140 m"));
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,high\n"), HasSubstr("'high' is no height"));
  EXPECT_THAT(refusal("time,height\n6 o'clock,1\n"), HasSubstr("is no time; write it as"));
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,1\n"), HasSubstr("holds one row"));
  EXPECT_THAT(refusal("2026-05-01T06:00\n"), HasSubstr("must hold a time and a height"));
}

}  // namespace
}  // namespace swathplan

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/sample_route.h"
#include "io/water/legs_csv.h"
#include "io/water/tide_import.h"
#include "io/water/times.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

TEST(Times, AreReadWithZonesAndWrittenInUtc) {
  EXPECT_EQ(time_of("1970-01-01T00:00"), 0.0);
  EXPECT_EQ(time_of("2026-05-01 06:30:15Z"), time_of("2026-05-01T08:30:15+02:00"));
  EXPECT_EQ(time_of("2026-05-01T06:30-0130"), time_of("2026-05-01T08:00"));
  for (const char* text : {"", "06:30", "2026-13-01T00:00", "2026-02-30T00:00", "2026-05-01",
                           "2026-05-01T25:00", "2026-05-01T06:30 CET", "01.05.2026 06:30"}) {
    EXPECT_FALSE(time_of(text)) << text;
  }
  for (const char* text :
       {"2026-05-01T06:30:15Z", "1969-12-31T23:59:59Z", "2024-02-29T00:00:00Z"}) {
    EXPECT_EQ(time_text(*time_of(text)), text);
  }
}

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
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,high\n"), HasSubstr("'high' is no height"));
  EXPECT_THAT(refusal("time,height\n6 o'clock,1\n"), HasSubstr("is no time; write it as"));
  EXPECT_THAT(refusal("time,height\n2026-05-01T06:00,1\n"), HasSubstr("holds one row"));
  EXPECT_THAT(refusal("2026-05-01T06:00\n"), HasSubstr("must hold a time and a height"));
}

TEST(LegsCsv, HasARowALeg) {
  const Route route = test::lawnmower(2);
  std::vector<LegWater> water(2);
  water[0] = {legs(route)[0], 0.0, 50.0, 3.25, 2.25, false, {{0.0, 60.0}, {120.0, 180.0}}};
  water[1] = {legs(route)[1], 50.0, 71.5, std::nullopt, std::nullopt, true, {}};
  const std::string text = legs_csv(route, water, 3600.0);
  EXPECT_THAT(text, HasSubstr("\r\n1,1,line,0.0,50.0,1970-01-01T01:00:00Z,1970-01-01T01:00:50Z,"
                              "3.25,2.25,0,1970-01-01T00:00:00Z/1970-01-01T00:01:00Z "
                              "1970-01-01T00:02:00Z/1970-01-01T00:03:00Z\r\n"));
  EXPECT_THAT(text, HasSubstr("\r\n2,,turn,50.0,71.5,"));
  EXPECT_THAT(legs_csv(route, water, std::nullopt), HasSubstr("\r\n1,1,line,0.0,50.0,,,3.25"));
}

}  // namespace
}  // namespace swathplan

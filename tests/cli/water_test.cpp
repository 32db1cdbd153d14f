// Water levels, chart datum and tides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::json_of;
using test::text_of;
using testing::HasSubstr;

const std::string kWaterHow = " --planner back-and-forth --resolution 0.4 --beams 64 --hit-only ";

/// 80 x 40 m of flat ground, 5 m deep.
class Water : public testing::Test {
 protected:
  Water() {
    EXPECT_EQ(folder.run("synth flat --width 80 --height 40 --depth 5 -o flat.asc").code, 0);
    folder.write("tide.csv",
                 "time,height_m\n2026-05-01T06:00,0.0\n2026-05-01T07:00,-2.0\n"
                 "2026-05-01T08:00,-4.6\n2026-05-01T09:00,0.0\n");
  }
  [[nodiscard]] test::Run plan(const std::string& more) const {
    return folder.run("plan flat.asc" + kWaterHow + more + " -o out");
  }
  Folder folder;
};

TEST_F(Water, LowWaterIsOneOption) {
  ASSERT_EQ(plan("--water-level -1.2").code, 0);
  const double draft = json_of(folder / "out" / "plan.json")["vehicle"]["draft_m"];
  EXPECT_NEAR(json_of(folder / "out" / "score.json")["min_under_keel_m"].get<double>(),
              5.0 - 1.2 - draft, 1e-6);
  // The same level, stated above a chart datum that lies 2 m under the file's.
  ASSERT_EQ(plan("--water-level 0.8 --chart-datum-offset -2").code, 0);
  EXPECT_NEAR(json_of(folder / "out" / "score.json")["min_under_keel_m"].get<double>(),
              5.0 - 1.2 - draft, 1e-6);
}

TEST_F(Water, ATideTellsWhatIsUnderTheKeelOfEachLeg) {
  const auto run = plan("--tide tide.csv --depart 2026-05-01T08:00");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("tide of 'tide.csv': 4 rows from 2026-05-01T06:00:00Z"));
  EXPECT_THAT(run.err, HasSubstr("are sailed with less than"));
  const std::string legs = text_of(folder / "out" / "water.csv");
  EXPECT_THAT(legs, HasSubstr("start_time,end_time,least_depth_m,under_keel_m"));
  EXPECT_THAT(legs, HasSubstr(",2026-05-01T08:00:00Z,"));
  // 5 m of water carry the boat until the tide has fallen by some 4 m.
  EXPECT_THAT(legs, HasSubstr(",1,2026-05-01T06:00:00Z/2026-05-01T07:"));
  // Without a tide the legs have their times alone, without either there is no table.
  ASSERT_EQ(plan("--depart 2026-05-01T08:00+02:00").code, 0);
  EXPECT_THAT(text_of(folder / "out" / "water.csv"), HasSubstr(",2026-05-01T06:00:00Z,"));
  ASSERT_EQ(plan("").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "water.csv"));
}

// 80 x 40 m, 5 m deep; an islet of 8 x 8 m stands in the west, in the east lie 8 x 8 m without
// data.
TEST_F(Water, LandIsToldFromGroundThatNobodySounded) {
  std::string grid =
      "ncols 80\nnrows 40\nxllcorner 500000\nyllcorner 6000000\ncellsize 1\n"
      "NODATA_value -9999\n";
  for (int row = 0; row < 40; ++row) {
    for (int x = 0; x < 80; ++x) {
      const bool inner = row >= 16 && row < 24;
      grid += inner && x >= 20 && x < 28 ? "2 " : inner && x >= 50 && x < 58 ? "-9999 " : "-5 ";
    }
    grid += "\n";
  }
  folder.write("islet.asc", grid);
  const auto scored = [&](const std::string& from, const std::string& to) {
    folder.write("way.csv", "x_m,y_m,kind\n" + from + ",6000020,line\n" + to + ",6000020,end\n");
    const auto run = folder.run(
        "score islet.asc way.csv --crs EPSG:32633 --hit-only --beams 64 "
        "--resolution 1 -o scored");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  // Over ground without data: a warning.
  EXPECT_THAT(scored("500040", "500070"), HasSubstr("over ground that the data do not tell of"));
  auto figures = json_of(folder / "scored" / "score.json");
  EXPECT_EQ(figures["over_land_m"], 0.0);
  EXPECT_NEAR(figures["over_unknown_m"].get<double>(), 9.0, 2.1);
  EXPECT_EQ(figures["infeasible_legs"], 0);
  // Over land: an error, and no mission.
  EXPECT_THAT(scored("500010", "500040"), HasSubstr("lead over land or through no-go areas"));
  figures = json_of(folder / "scored" / "score.json");
  EXPECT_NEAR(figures["over_land_m"].get<double>(), 8.0, 1.0);
  EXPECT_EQ(figures["over_unknown_m"], 0.0);
  EXPECT_EQ(figures["infeasible_legs"], 1);
  EXPECT_THAT(text_of(folder / "scored" / "report.html"),
              HasSubstr("leads over land or through a no-go area"));
  const auto kept = folder.run(
      "plan islet.asc --keep way.csv --crs EPSG:32633 --hit-only --beams 64 "
      "--resolution 1 --export plan,lnw -o kept");
  EXPECT_EQ(kept.code, 0) << kept.err;
  EXPECT_THAT(kept.err, HasSubstr("no plan was written"));
  EXPECT_FALSE(std::filesystem::exists(folder / "kept" / "route.plan"));
}

TEST_F(Water, TablesAndTimesThatCannotBeUsedAreNamed) {
  folder.write("gap.csv",
               "2026-05-01T06:00,1\n2026-05-01T07:00,1\n2026-05-01T08:00,1\n2026-05-01T14:00,1\n");
  folder.write("unsorted.csv", "2026-05-01T06:00,1\n2026-05-01T05:00,1\n");
  const auto gap = plan("--tide gap.csv");
  EXPECT_EQ(gap.code, 1);
  EXPECT_THAT(gap.err, HasSubstr("'gap.csv', line 4: a gap of 6.0 h"));
  const auto unsorted = plan("--tide unsorted.csv");
  EXPECT_EQ(unsorted.code, 1);
  EXPECT_THAT(unsorted.err, HasSubstr("'unsorted.csv', line 2"));
  const auto early = plan("--tide tide.csv --depart 2026-04-30T08:00");
  EXPECT_EQ(early.code, 2);
  EXPECT_THAT(early.err, HasSubstr("outside the table of 'tide.csv'"));
  const auto spoken = plan("--depart 'tomorrow morning'");
  EXPECT_EQ(spoken.code, 2);
  EXPECT_THAT(spoken.err, HasSubstr("--depart 'tomorrow morning' is no time"));
}

}  // namespace
}  // namespace swathplan

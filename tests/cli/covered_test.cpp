// `--covered`: what was surveyed before is not planned again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::json_of;
using testing::HasSubstr;

const std::string kCoveredHow = " --planner back-and-forth --resolution 0.4 --beams 64 --hit-only ";

/// 120 x 60 m of flat ground, 12 m deep, in UTM 30N.
class Covered : public testing::Test {
 protected:
  Covered() {
    EXPECT_EQ(folder.run("synth flat --width 120 --height 60 --depth 12 -o flat.asc").code, 0);
    write_box("west.geojson", "32630", -10, -10, 60, 100);
  }

  void write_box(const std::string& file, const std::string& crs, double x0, double y0, double x1,
                 double y1) const {
    std::ostringstream ring;
    ring << "[[[" << x0 << ',' << y0 << "],[" << x1 << ',' << y0 << "],[" << x1 << ',' << y1
         << "],[" << x0 << ',' << y1 << "],[" << x0 << ',' << y0 << "]]]";
    folder.write(file, R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
                       R"("urn:ogc:def:crs:EPSG::)" +
                           crs +
                           R"("}},"features":[{"type":"Feature","properties":{},"geometry":)"
                           R"({"type":"Polygon","coordinates":)" +
                           ring.str() + "}}]}");
  }

  [[nodiscard]] test::Run plan(const std::string& more, const std::string& out = "out") const {
    return folder.run("plan flat.asc --crs EPSG:32630" + kCoveredHow + more + " -o " + out);
  }

  Folder folder;
};

TEST_F(Covered, HalfOfTheAreaGivenAsPolygonsLeavesTheOtherHalf) {
  const auto run = plan("--covered west.geojson");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("'west.geojson' was read as polygons: it covers 50.00 %"));
  EXPECT_THAT(run.out, HasSubstr("of the whole survey area are covered"));
  const auto score = json_of(folder / "out" / "score.json");
  EXPECT_NEAR(score["survey_area_m2"].get<double>(), 3600.0, 0.1);
  EXPECT_NEAR(score["whole_area_m2"].get<double>(), 7200.0, 0.1);
  EXPECT_EQ(score["whole_cells"], 45000);
  EXPECT_NEAR(score["covered_before_pct"].get<double>(), 50.0, 1e-9);
  EXPECT_NEAR(score["coverage_whole_logged_pct"].get<double>(),
              50.0 + 0.5 * score["coverage_hit_logged_pct"].get<double>(), 0.01);
}

TEST_F(Covered, TheRouteAndTheRasterOfAPlanCoverWhatItsScoreSays) {
  ASSERT_EQ(plan("--run-in -10 --run-out -10", "first").code, 0);
  const auto first = json_of(folder / "first" / "score.json");
  const double hit = first["coverage_hit_pct"], logged = first["coverage_hit_logged_pct"];
  ASSERT_GT(logged, 20.0);
  ASSERT_GT(hit, logged);
  ASSERT_LT(hit, 95.0);
  // The raster counts all soundings. Of tracks those of logged legs count. Places in files are
  // rounded, and what is left begins at other borders of cells: a few soundings fall into the
  // neighbour.
  const std::pair<std::string, double> cases[] = {
      {"first/coverage.tif", hit}, {"first/route.csv", logged}, {"first/route.geojson", logged}};
  for (const auto& [file, covered] : cases) {
    // Scoring asks for no line in what is left.
    const auto run = folder.run(
        "score flat.asc first/route.csv --crs EPSG:32630 --resolution 0.4 --beams 64 --hit-only "
        "-o again --covered " +
        file);
    ASSERT_EQ(run.code, 0) << file << run.err;
    const auto score = json_of(folder / "again" / "score.json");
    EXPECT_NEAR(score["covered_before_pct"].get<double>(), covered, 0.6) << file;
    EXPECT_NEAR(score["coverage_whole_logged_pct"].get<double>(), covered, 0.6) << file;
  }
}

TEST_F(Covered, DepthRastersAndSoundingsCoverTheirGround) {
  ASSERT_EQ(folder.run("synth flat --width 40 --height 60 --depth 3 -o old.asc").code, 0);
  const auto raster = plan("--covered old.asc");
  ASSERT_EQ(raster.code, 0) << raster.err;
  EXPECT_THAT(raster.err, HasSubstr("was read as cells with a value"));
  EXPECT_NEAR(json_of(folder / "out" / "score.json")["covered_before_pct"].get<double>(), 33.3,
              1.0);
  std::string points = "x,y,depth\n";
  for (int x = 0; x <= 30; ++x) {
    for (int y = 0; y <= 60; ++y) points += std::to_string(x) + "," + std::to_string(y) + ",9\n";
  }
  folder.write("old.csv", points);
  const auto soundings = plan("--covered old.csv");
  ASSERT_EQ(soundings.code, 0) << soundings.err;
  EXPECT_THAT(soundings.err, HasSubstr("was read as the ground between soundings"));
  EXPECT_NEAR(json_of(folder / "out" / "score.json")["covered_before_pct"].get<double>(), 25.0,
              0.5);
}

TEST_F(Covered, ATrackWithoutAnglesAsksHowWideItWasSurveyed) {
  folder.write("sailed.csv", "x,y\n0,30\n120,30\n");
  const auto asked = plan("--covered sailed.csv");
  EXPECT_EQ(asked.code, 1);
  EXPECT_THAT(asked.err, HasSubstr("'sailed.csv' is a track without opening angles"));
  EXPECT_THAT(asked.err, HasSubstr("--covered-swath"));
  EXPECT_THAT(asked.err, HasSubstr("--covered-opening"));
  const auto strip = plan("--covered sailed.csv --covered-swath 15");
  ASSERT_EQ(strip.code, 0) << strip.err;
  EXPECT_NEAR(json_of(folder / "out" / "score.json")["covered_before_pct"].get<double>(), 25.0,
              0.5);
  const auto fan = plan("--covered sailed.csv --covered-opening 90");
  ASSERT_EQ(fan.code, 0) << fan.err;
  EXPECT_GT(json_of(folder / "out" / "score.json")["covered_before_pct"].get<double>(), 20.0);
  EXPECT_EQ(plan("--covered sailed.csv --covered-opening 90 --covered-swath 4").code, 2);
}

TEST_F(Covered, SeveralFilesAddUp) {
  write_box("north.geojson", "32630", -10, 30, 300, 100);
  for (const std::string files :
       {"--covered west.geojson,north.geojson", "--covered west.geojson --covered north.geojson"}) {
    const auto run = plan(files);
    ASSERT_EQ(run.code, 0) << run.err;
    const double before = json_of(folder / "out" / "score.json")["covered_before_pct"];
    EXPECT_NEAR(before, 75.0, 1e-9) << files;
  }
}

TEST_F(Covered, FilesThatCannotBeUsedAreNamed) {
  write_box("zone31.geojson", "32631", 0, 0, 60, 60);
  write_box("aside.geojson", "32630", 121, 10, 150, 20);
  write_box("all.geojson", "32630", -10, -10, 200, 200);
  folder.write("empty.csv", "");
  ASSERT_EQ(folder.run("synth flat --width 20 --height 20 -o small.asc").code, 0);
  folder.write("far.csv", "x,y,depth\n900,900,5\n901,900,5\n900,901,5\n901,901,5\n");
  const std::pair<const char*, const char*> cases[] = {
      {"zone31.geojson", "check their coordinate reference system"},
      {"aside.geojson", "do not meet the seafloor"},
      {"far.csv", "covers no cell of the survey area (x 0.0 to 120.0"},
      {"all.geojson", "is covered already (100.00 % of its cells): nothing is left"},
      {"none.tif", "'none.tif' does not exist"},
      {"empty.csv", "'empty.csv' is empty"},
  };
  for (const auto& [file, why] : cases) {
    const auto run = plan("--covered " + std::string(file));
    EXPECT_EQ(run.code, 1) << file;
    EXPECT_THAT(run.err, HasSubstr(why));
  }
}

}  // namespace
}  // namespace swathplan

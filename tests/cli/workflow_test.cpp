#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.h"

namespace swathplan {
namespace {

using nlohmann::json;
using test::dataset;
using test::Folder;
using test::json_of;
using test::text_of;

TEST(Synth, RegeneratesTheShippedDatasetsByteForByte) {
  const Folder folder;
  for (const auto& [shape, file] :
       {std::pair("saddle", "saddle.asc"), std::pair("shaft", "shaft.obj"),
        std::pair("harbour", "harbour.asc")}) {
    ASSERT_EQ(folder.run(std::string("synth ") + shape + " -o " + file).code, 0);
    EXPECT_TRUE(text_of(folder / file) == text_of(dataset(file))) << file;
    EXPECT_GT(text_of(dataset(file)).size(), 1000U);
  }
}

TEST(Inspect, SaysWhatIsInTheHarbour) {
  const Folder folder;
  const auto run = folder.run("inspect " + dataset("harbour.asc"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("grid"), std::string::npos) << run.out;
  const auto as_json = folder.run("inspect --json " + dataset("harbour.asc"));
  EXPECT_TRUE(json::accept(as_json.out)) << as_json.out;
}

TEST(Inspect, JsonSurvivesAFileNameThatIsNotUtf8) {
  const Folder folder;
  folder.write("r\xF8nne.asc", text_of(dataset("saddle.asc")));
  const auto run = folder.run("inspect --json 'r\xF8nne.asc'");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(json::accept(run.out)) << run.out;
}

TEST(Plan, WritesEveryFileAndTheyAgree) {
  const Folder folder;
  const auto run = folder.run("plan " + dataset("saddle.asc") +
                              " --planner mdnuc --depth-bands 4 --face-size 1 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* name :
       {"route.csv", "route.local.geojson", "score.json", "plan.json", "coverage.tif",
        "coverage.png", "holidays.local.geojson", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out")) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << "left behind";
  }
  const json score = json_of(folder / "out" / "score.json");
  EXPECT_GT(score.at("coverage_hit_pct").get<double>(), 85.0);
  EXPECT_GT(score.at("length_ratio").get<double>(), 2.0);
  EXPECT_EQ(score.at("self_crossings").get<int>(), 0);
  EXPECT_LT(score.at("outside_water_m").get<double>(), 0.01);

  // The printed table counts all holidays, as score.json does. Four columns follow that count.
  const std::size_t first = run.out.find('\n') + 1;
  std::istringstream printed(run.out.substr(first, run.out.find('\n', first) - first));
  const std::vector<std::string> words{std::istream_iterator<std::string>(printed), {}};
  ASSERT_GT(words.size(), 5U);
  EXPECT_EQ(words[words.size() - 5], std::to_string(score.at("holidays").get<std::size_t>()))
      << run.out;

  // The raster says the same as the score: empty cells over all that count.
  GDALAllRegister();
  const GDALDatasetUniquePtr tif(
      GDALDataset::Open((folder / "out" / "coverage.tif").c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(tif);
  GDALRasterBand* band = tif->GetRasterBand(1);
  std::vector<std::uint16_t> row(static_cast<std::size_t>(band->GetXSize()));
  std::size_t cells = 0;
  std::size_t hit = 0;
  for (int y = 0; y < band->GetYSize(); ++y) {
    ASSERT_EQ(band->RasterIO(GF_Read, 0, y, band->GetXSize(), 1, row.data(), band->GetXSize(), 1,
                             GDT_UInt16, 0, 0),
              CE_None);
    for (const std::uint16_t n : row) {
      if (n == 65535) continue;
      ++cells;
      if (n > 0) ++hit;
    }
  }
  EXPECT_EQ(cells, score.at("cells").get<std::size_t>());
  EXPECT_NEAR(100.0 * static_cast<double>(hit) / static_cast<double>(cells),
              score.at("coverage_hit_pct").get<double>(), 1e-6);

  const json plan = json_of(folder / "out" / "plan.json");
  EXPECT_GE(plan.at("regions").size(), 2U);
  EXPECT_EQ(plan.at("gates").size(), plan.at("regions").size() - 1);
  EXPECT_GT(plan.at("blocked_edges").size(), 0U);

  const std::string report = text_of(folder / "out" / "report.html");
  EXPECT_EQ(report.find("http://"), report.find("http://www.w3.org")) << "no outside request";
}

TEST(Plan, ScoringItsOwnRouteGivesTheSameScore) {
  const Folder folder;
  ASSERT_EQ(
      folder.run("plan " + dataset("shaft.obj") + " --planner back-and-forth -o a --quiet").code,
      0);
  for (const char* route : {"a/route.csv", "a/route.local.geojson"}) {
    const auto run = folder.run("score " + dataset("shaft.obj") + " " + route + " -o b");
    ASSERT_EQ(run.code, 0) << run.err;
    const json a = json_of(folder / "a" / "score.json");
    const json b = json_of(folder / "b" / "score.json");
    EXPECT_NEAR(a.at("coverage_hit_pct").get<double>(), b.at("coverage_hit_pct").get<double>(),
                0.02);
    EXPECT_NEAR(a.at("length_m").get<double>(), b.at("length_m").get<double>(), 0.01);
    EXPECT_EQ(a.at("cells"), b.at("cells"));
  }
}

TEST(Plan, TheSameBytesForAnyNumberOfThreadsAndTwice) {
  const Folder folder;
  const std::string command = "plan " + dataset("saddle.asc") +
                              " --planner mdnuc --noise calm --seed 7 --quiet --resolution 0.2 ";
  ASSERT_EQ(folder.run(command + "--threads 1 -o a").code, 0);
  ASSERT_EQ(folder.run(command + "--threads 2 -o b").code, 0);
  ASSERT_EQ(folder.run(command + "--threads 2 -o c").code, 0);
  for (const char* name : {"route.csv", "score.json", "plan.json", "coverage.tif"}) {
    EXPECT_TRUE(text_of(folder / "a" / name) == text_of(folder / "b" / name)) << name;
    EXPECT_TRUE(text_of(folder / "b" / name) == text_of(folder / "c" / name)) << name;
  }
}

TEST(Plan, SmoothsJoinsOfPlannersWithoutASkeletonAndSaysSo) {
  const Folder folder;
  for (const char* planner : {"back-and-forth", "multi-depth"}) {
    SCOPED_TRACE(planner);
    const std::string command =
        "plan " + dataset("shaft.obj") + " --hit-only --quiet --planner " + planner;
    ASSERT_EQ(folder.run(command + " -o arcs").code, 0);
    ASSERT_EQ(folder.run(command + " --smooth ipopt -o smooth").code, 0);
    const json plan = json_of(folder / "smooth" / "plan.json");
    EXPECT_NE(plan.at("notes").dump().find("joins smoothed"), std::string::npos);
    const json before = json_of(folder / "arcs" / "score.json");
    const json after = json_of(folder / "smooth" / "score.json");
    EXPECT_GE(after.at("min_turn_radius_m").get<double>(), 1.5);
    EXPECT_EQ(after.at("outside_water_m").get<double>(), 0.0);
    EXPECT_EQ(after.at("infeasible_legs"), before.at("infeasible_legs"));
    EXPECT_NEAR(after.at("coverage_hit_pct").get<double>(),
                before.at("coverage_hit_pct").get<double>(), 0.5);
    EXPECT_FALSE(text_of(folder / "arcs" / "route.csv") ==
                 text_of(folder / "smooth" / "route.csv"));
  }
}

TEST(Compare, HoldsFourPlannersAgainstEachOther) {
  const Folder folder;
  const auto run =
      folder.run("compare " + dataset("shaft.obj") +
                 " --planners back-and-forth,multi-depth,nuc,mdnuc --resolution 0.25 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("The best of "));
  const json all = json_of(folder / "out" / "compare.json");
  ASSERT_EQ(all.size(), 4U);
  std::map<std::string, double> hit;
  for (const json& score : all) {
    hit[score.at("planner").get<std::string>()] = score.at("coverage_hit_pct").get<double>();
    EXPECT_LT(score.at("outside_water_m").get<double>(), 0.01);
  }
  EXPECT_GT(hit.at("mdnuc"), hit.at("back-and-forth") + 10.0);
  for (const auto& [name, pct] : hit) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name / "route.csv"));
    EXPECT_NE(text_of(folder / "out" / "report.html").size(), 0U);
  }
}

TEST(Compare, NucAndMdnucWalkQuadsOnRequest) {
  const Folder folder;
  const std::string command =
      "compare " + dataset("saddle.asc") + " --planners nuc,mdnuc --depth-bands 4 --hit-only ";
  const auto triangles = folder.run(command + "--face-size 0.93 -o triangles");
  ASSERT_EQ(triangles.code, 0) << triangles.err;
  const auto quads = folder.run(command + "--faces quad --face-size 0.75 -o quads");
  ASSERT_EQ(quads.code, 0) << quads.err;
  const json plan = json_of(folder / "quads" / "mdnuc" / "plan.json");
  EXPECT_EQ(plan.at("options").at("faces"), "quad");
  const json on_triangles = json_of(folder / "triangles" / "mdnuc" / "score.json");
  for (const char* planner : {"nuc", "mdnuc"}) {
    const json score = json_of(folder / "quads" / planner / "score.json");
    EXPECT_GT(score.at("coverage_hit_pct").get<double>(), 88.0);
    EXPECT_EQ(score.at("self_crossings").get<int>(), 0);
    EXPECT_LT(score.at("outside_water_m").get<double>(), 0.01);
  }
  EXPECT_LT(json_of(folder / "quads" / "mdnuc" / "score.json").at("length_m").get<double>(),
            0.9 * on_triangles.at("length_m").get<double>());
}

TEST(Lines, WriteARouteAPictureAndFiguresThatAgree) {
  const Folder folder;
  ASSERT_EQ(
      folder.run("synth tilted --width 300 --height 200 --depth 20 --slope 2 -o slope.asc").code,
      0);
  const auto run = folder.run(
      "lines slope.asc --method straight,edge-following --draft 0 --clearance 0.05 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const json all = json_of(folder / "out" / "lines.json");
  ASSERT_EQ(all.at("methods").size(), 2U);
  for (const json& method : all.at("methods")) {
    EXPECT_LE(method.at("missed_pct").get<double>(), 0.05);
    EXPECT_GE(method.at("length_ratio_to_least").get<double>(), 1.0);
    const auto sub = folder / "out" / method.at("method").get<std::string>();
    EXPECT_TRUE(std::filesystem::exists(sub / "lines.png"));
    EXPECT_EQ(folder
                  .run("score slope.asc " + (sub / "route.csv").string() +
                       " --resolution 2 --ping-spacing 2 --hit-only -o scored")
                  .code,
              0);
    const json score = json_of(folder / "scored" / "score.json");
    // Rays see what the swaths promised.
    EXPECT_GT(score.at("coverage_hit_logged_pct").get<double>(), 97.0);
  }
}

TEST(Plan, FittedLinesAreJudgedByFootprintsOnRequest) {
  const Folder folder;
  const std::string common = "plan " + dataset("saddle.asc") +
                             " --resolution 0.2 --run-out-margin 10 --coverage 99 --cover "
                             "footprint ";
  const auto run = folder.run(common + "-o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const json score = json_of(folder / "out" / "score.json");
  EXPECT_GE(score.at("coverage_footprint_pct").get<double>(), 99.0);
  const json plan = json_of(folder / "out" / "plan.json");
  bool picked = false;
  for (const json& choice : plan.at("choices")) {
    if (!choice.at("picked").get<bool>()) continue;
    picked = true;
    EXPECT_NEAR(choice.at("coverage_footprint_pct").get<double>(),
                score.at("coverage_footprint_pct").get<double>(), 1e-6);
  }
  EXPECT_TRUE(picked);
}

TEST(Plan, AreaAndNoGoAreHonoured) {
  const Folder folder;
  const auto polygon = [](double x0, double y0, double x1, double y1) {
    std::ostringstream text;
    text << R"({"type":"Polygon","coordinates":[[[)" << x0 << ',' << y0 << "],[" << x1 << ',' << y0
         << "],[" << x1 << ',' << y1 << "],[" << x0 << ',' << y1 << "],[" << x0 << ',' << y0
         << "]]]}";
    return text.str();
  };
  folder.write("area.geojson", polygon(150, 140, 280, 380));
  folder.write("nogo.geojson", polygon(200, 200, 220, 230));
  const auto run = folder.run("plan " + dataset("harbour.asc") +
                              " --planner nuc --area area.geojson --no-go nogo.geojson -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const json score = json_of(folder / "out" / "score.json");
  EXPECT_LT(score.at("outside_water_m").get<double>(), 0.01);
  EXPECT_LT(score.at("survey_area_m2").get<double>(), 130.0 * 240.0 - 600.0);
  EXPECT_GT(score.at("survey_area_m2").get<double>(), 20000.0);
}

// A real UTM seafloor with a CRS: coordinates and lon/lat must survive the way through the program.
TEST(Plan, ProjectedDataComeOutInLongitudeAndLatitude) {
  const std::string file =
      std::string(SWATHPLAN_SOURCE_DIR) + "/../shared/datasets/ela_lake_soundings/227_LA.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the lake's soundings are not there";
  const Folder folder;
  const auto run = folder.run(
      "plan '" + file + "' --crs EPSG:4326 --planner back-and-forth --resolution 0.25 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  GDALAllRegister();
  const GDALDatasetUniquePtr route(
      GDALDataset::Open((folder / "out" / "route.geojson").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(route);
  OGREnvelope box;
  ASSERT_EQ(route->GetLayer(0)->GetExtent(&box), OGRERR_NONE);
  EXPECT_NEAR(box.MinX, -93.69, 0.02);
  EXPECT_NEAR(box.MinY, 49.69, 0.02);
}

}  // namespace
}  // namespace swathplan

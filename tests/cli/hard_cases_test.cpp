// Places and routes where a plan gets hard: each ends in a clear status.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace swathplan {
namespace {

using nlohmann::json;
using test::dataset;
using test::Folder;
using test::json_of;
using test::text_of;

/// A grid of 5 m cells from rows of '.' (10 m deep) and '#' (no data).
std::string grid(const std::vector<std::string>& rows) {
  std::string text = "ncols " + std::to_string(rows.front().size()) + "\nnrows " +
                     std::to_string(rows.size()) +
                     "\nxllcorner 0\nyllcorner 0\ncellsize 5\nNODATA_value -9999\n";
  for (const std::string& row : rows) {
    for (const char c : row) text += c == '.' ? "-10 " : "-9999 ";
    text += "\n";
  }
  return text;
}

/// Every leg that cannot be sailed is marked, counted, and has a reason and a place; and nothing
/// lies outside the water.
void expect_told(const Folder& folder, bool any) {
  const json score = json_of(folder / "out" / "score.json");
  const json plan = json_of(folder / "out" / "plan.json");
  EXPECT_LT(score.at("outside_water_m").get<double>(), 0.01);
  std::size_t told = 0;
  for (const json& v : plan.at("violations")) {
    EXPECT_FALSE(v.at("reason").get<std::string>().empty());
    EXPECT_EQ(v.at("at_xy").size(), 2U);
    told += v.at("what") == "infeasible" ? 1 : 0;
  }
  EXPECT_EQ(told, score.at("infeasible_legs").get<std::size_t>());
  EXPECT_EQ(told > 0, any);
  EXPECT_EQ(score.at("infeasible_m").get<double>() > 0.0, any);
  EXPECT_EQ(text_of(folder / "out" / "route.csv").find("infeasible") != std::string::npos, any);
}

TEST(HardCase, AChannelNarrowerThanTwiceTheRadius) {
  const Folder folder;
  folder.write("channel.asc", grid({"######....", "######....", "..........", "..........",
                                    "######....", "######...."}));
  for (const char* planner : {"back-and-forth", "mdnuc"}) {
    const auto run = folder.run(std::string("plan channel.asc --vehicle small-usv --planner ") +
                                planner + " -o out");
    EXPECT_EQ(run.code, 0) << run.err;
    const json score = json_of(folder / "out" / "score.json");
    expect_told(folder, score.at("infeasible_legs").get<int>() > 0);
  }
}

TEST(HardCase, ABasinThatOnlyAReverseCouldLeave) {
  const Folder folder;
  folder.write("basin.asc", grid(std::vector<std::string>(10, "..........")));
  const auto run =
      folder.run("plan basin.asc --vehicle launch --planner back-and-forth -o out --margin 1");
  EXPECT_EQ(run.code, 0) << run.err;
  expect_told(folder, true);
}

TEST(HardCase, StartOnLand) {
  const Folder folder;
  const auto run = folder.run("plan " + dataset("harbour.asc") +
                              " --planner back-and-forth --resolution 0.5 --start 5,300 -o out");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("--start"), std::string::npos) << run.err;
  EXPECT_LT(json_of(folder / "out" / "score.json").at("outside_water_m").get<double>(), 0.01);
}

TEST(HardCase, ASingleRegionOfASingleFace) {
  const Folder folder;
  folder.write("face.obj", "v 0 0 -9\nv 20 0 -9\nv 0 20 -9\nf 1 2 3\n");
  for (const char* options :
       {"nuc", "mdnuc", "mdnuc --smooth ipopt", "back-and-forth", "multi-depth"}) {
    const auto run =
        folder.run(std::string("plan face.obj --clearance 0.1 -o out --planner ") + options);
    EXPECT_EQ(run.code, 0) << options << ": " << run.err;
    EXPECT_LT(json_of(folder / "out" / "score.json").at("outside_water_m").get<double>(), 0.01);
  }
}

/// 12 x 12 soundings in degrees at 60 N, 2.5 degrees west of the middle of UTM zone 33.
std::string soundings_in_degrees() {
  std::string rows = "lon,lat,depth\n";
  for (int i = 0; i < 144; ++i) {
    rows += std::to_string(12.5 + 0.0002 * (i % 12)) + "," +
            std::to_string(60.0 + 0.0001 * (i / 12)) + ",10\n";
  }
  return rows;
}

TEST(HardCase, HeadingsAreTrueAndStartsAreInTheFilesDegrees) {
  const Folder folder;
  folder.write("a.csv", soundings_in_degrees());
  const std::string plan =
      "plan a.csv --planner back-and-forth --beams 40 --resolution 0.5 --hit-only --heading 0 ";
  const auto run = folder.run(plan + "--start=12.5022,60.0 -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("west of true north"), std::string::npos) << run.err;
  const json made = json_of(folder / "out" / "plan.json");
  EXPECT_NEAR(made.at("heading_true_deg").get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(made.at("heading_grid_deg").get<double>(), 2.17, 0.02);
  const json line = json_of(folder / "out" / "route.geojson").at("features").at(0);
  const json& at = line.at("geometry").at("coordinates");
  EXPECT_NEAR(at.front().at(0).get<double>(), at.back().at(0).get<double>(), 1e-6);
  EXPECT_GT(at.front().at(0).get<double>(), 12.5015);  // near the start, not the western edge
  ASSERT_EQ(folder.run(plan + "--north grid -o grid --quiet").code, 0);
  EXPECT_NEAR(json_of(folder / "grid" / "plan.json").at("heading_grid_deg").get<double>(), 0.0,
              1e-6);
  const auto metres = folder.run(plan + "--start=361000,6654000 -o none");
  EXPECT_EQ(metres.code, 2);
  EXPECT_NE(metres.err.find("is in degrees"), std::string::npos) << metres.err;
}

TEST(HardCase, LinesWriteNoMissionOverLand) {
  const Folder folder;
  const std::string water(24, '.');
  std::vector<std::string> rows;
  for (int i = 0; i < 20; ++i) rows.push_back(water + "####" + water);
  folder.write("two.asc", grid(rows));
  const auto run = folder.run(
      "lines two.asc --crs EPSG:32633 --method straight --heading 0 --export waypoints,gpx,lnw "
      "-o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("no waypoints, gpx was written"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "straight" / "route.waypoints"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "straight" / "route.gpx"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "straight" / "route.lnw"));
  EXPECT_TRUE(json_of(folder / "out" / "lines.json")
                  .at("methods")
                  .at(0)
                  .at("exports_left_out")
                  .is_string());
  const auto again = folder.run("export out/straight/route.csv --format gpx -o exported");
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.err.find("infeasible"), std::string::npos) << again.err;
}

TEST(HardCase, PolygonsWithoutALineAreNamed) {
  const Folder folder;
  folder.write("flat.asc", grid(std::vector<std::string>(20, std::string(20, '.'))));
  const auto square = [](const std::string& properties, int x, int y, int side) {
    const auto p = [&](int dx, int dy) {
      return "[" + std::to_string(x + dx * side) + "," + std::to_string(y + dy * side) + "]";
    };
    return R"({"type":"Feature","properties":)" + properties +
           R"(,"geometry":{"type":"Polygon","coordinates":[[)" + p(0, 0) + "," + p(1, 0) + "," +
           p(1, 1) + "," + p(0, 1) + "," + p(0, 0) + "]]}}";
  };
  folder.write("areas.geojson", R"({"type":"FeatureCollection","features":[)" +
                                    square(R"({"name":"basin"})", 10, 10, 60) + "," +
                                    square(R"({"name":"creek"})", 200, 10, 10) + "," +
                                    square("{}", 10, 200, 10) + "]}");
  const auto run = folder.run(
      "plan flat.asc --planner back-and-forth --beams 40 --resolution 0.5 --hit-only --area "
      "areas.geojson -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("2 of 3 polygons of the area have no survey line: 'creek' about "),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("the one about ("), std::string::npos) << run.err;
  EXPECT_NE(text_of(folder / "out" / "report.html").find("creek"), std::string::npos);
  EXPECT_EQ(run.err.find("'basin'"), std::string::npos) << run.err;
}

TEST(HardCase, AClosedLoopAndWaypointsThatCoincide) {
  const Folder folder;
  folder.write("loop.csv",
               "x,y\n-20,-20\n20,-20\n20,-20\n20,20\n-20,20\n-20,20\n-20,20\n-20,-20\n");
  const auto run =
      folder.run("score " + dataset("saddle.asc") + " loop.csv --resolution 0.5 -o out");
  EXPECT_EQ(run.code, 0) << run.err;
  const json score = json_of(folder / "out" / "score.json");
  EXPECT_NEAR(score.at("length_m").get<double>(), 160.0, 1e-6);
  EXPECT_EQ(score.at("turns").get<int>(), 3);
}

TEST(HardCase, AMissionLongerThanTheEnduranceWithItsContingency) {
  const Folder folder;
  const auto score_with = [&](const std::string& options) {
    const auto run = folder.run("score " + dataset("saddle.asc") +
                                " line.csv --resolution 0.5 --speed 2 -o out " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err.find("endurance") != std::string::npos,
              json_of(folder / "out" / "score.json").at("beyond_endurance").get<bool>())
        << run.err;
    return json_of(folder / "out" / "score.json");
  };
  folder.write("line.csv", "x,y\n-20,-20\n20,-20\n");  // 20 s
  const json usual = score_with("");
  EXPECT_DOUBLE_EQ(usual.at("contingency_s").get<double>(), 2.0);
  EXPECT_DOUBLE_EQ(usual.at("duration_with_contingency_s").get<double>(), 22.0);
  EXPECT_DOUBLE_EQ(usual.at("options").at("contingency_pct").get<double>(), 10.0);
  EXPECT_FALSE(usual.at("beyond_endurance").get<bool>());
  const json none = score_with("--contingency 0 --endurance 0.006");  // 21.6 s
  EXPECT_DOUBLE_EQ(none.at("contingency_s").get<double>(), 0.0);
  EXPECT_FALSE(none.at("beyond_endurance").get<bool>());
  const json tenth = score_with("--endurance 0.006");
  EXPECT_TRUE(tenth.at("beyond_endurance").get<bool>());
  const std::string plan = text_of(folder / "out" / "plan.json");
  EXPECT_NE(plan.find("endurance of 0.006 h"), std::string::npos) << plan;
  EXPECT_NE(text_of(folder / "out" / "report.html").find("endurance of 0.006 h"),
            std::string::npos);
}

}  // namespace
}  // namespace swathplan

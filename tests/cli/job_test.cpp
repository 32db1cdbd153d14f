#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
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

/// Back and forth over the sample harbour in coarse cells: about a second.
std::string harbour_job(const std::string& more) {
  const bool plans = more.find("--keep") == std::string::npos;
  return "plan " + dataset("harbour.asc") + (plans ? " --planner back-and-forth" : "") +
         " --resolution 0.5 --ping-spacing 2 --hit-only --max-opening 130 "
         "--vehicle small-usv --clearance 1.5 " +
         more;
}
/// In the basin of the harbour, in safe water.
const char* const kBerth = "--berth 150,200";

std::vector<std::vector<std::string>> route_rows(const std::filesystem::path& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream text(text_of(csv));
  std::string line;
  while (std::getline(text, line)) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else if (c != '\r') {
        cells.back() += c;
      }
    }
    rows.push_back(cells);
  }
  return rows;
}

void expect_at(const std::vector<std::string>& row, double x, double y) {
  EXPECT_NEAR(std::stod(row.at(4)), x, 0.01);
  EXPECT_NEAR(std::stod(row.at(5)), y, 0.01);
}

TEST(Job, BerthAndBack) {
  const Folder folder;
  const auto run = folder.run(harbour_job(std::string(kBerth) + " -o out"));
  ASSERT_EQ(run.code, 0) << run.err;
  const auto rows = route_rows(folder / "out/route.csv");
  expect_at(rows.at(1), 150, 200);
  expect_at(rows.back(), 150, 200);
  const json score = json_of(folder / "out/score.json");
  EXPECT_LT(score.at("outside_water_m").get<double>(), 0.05);
  EXPECT_EQ(json_of(folder / "out/plan.json").at("job").at("berth_xy"), json({150.0, 200.0}));
}

TEST(Job, ABerthOnLandOrNoPlaceIsRefusedWithTheNearestSafeWater) {
  const Folder folder;
  const auto land = folder.run(harbour_job("--berth=-60,200 -o out"));
  EXPECT_EQ(land.code, 2);
  EXPECT_NE(land.err.find("--berth -60,200"), std::string::npos) << land.err;
  EXPECT_NE(land.err.find("on land"), std::string::npos) << land.err;
  EXPECT_NE(land.err.find("the nearest safe water is"), std::string::npos) << land.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  const auto odd = folder.run(harbour_job("--berth 150 -o out"));
  EXPECT_EQ(odd.code, 2);
  EXPECT_NE(odd.err.find("must be X,Y"), std::string::npos) << odd.err;
}

TEST(Job, ABerthThatIsCutOffIsRefused) {
  const Folder folder;
  // A no-go strip that splits a basin in two.
  ASSERT_EQ(folder.run("synth flat --width 200 --height 100 --depth 10 -o flat.asc").code, 0);
  folder.write("area.geojson",
               R"({"type":"Polygon","coordinates":[[[60,5],[95,5],[95,95],[60,95],[60,5]]]})");
  folder.write(
      "wall.geojson",
      R"({"type":"Polygon","coordinates":[[[40,-10],[50,-10],[50,300],[40,300],[40,-10]]]})");
  const auto run = folder.run(
      "plan flat.asc --planner back-and-forth --resolution 0.5 --hit-only --area area.geojson "
      "--no-go wall.geojson --berth 20,50 -o out");
  EXPECT_EQ(run.code, 2) << run.out;
  EXPECT_NE(run.err.find("--berth at 20.0,50.0 is cut off"), std::string::npos) << run.err;
}

TEST(Job, CrossLinesHaveTheirShareAndAreSailedFirst) {
  const Folder folder;
  const auto run = folder.run(harbour_job("--cross-lines 5 -o out"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json score = json_of(folder / "out/score.json");
  const double share = score.at("cross_lines_share_pct").get<double>();
  EXPECT_GE(share, 5.0 - 1e-6);
  EXPECT_LT(share, 8.0);
  EXPECT_GE(score.at("cross_lines_crossings").get<int>(), 2);
  EXPECT_NEAR(score.at("length_by_kind_m").at("cross").get<double>(),
              score.at("cross_lines_length_m").get<double>(), 1e-6);
  std::string first;
  for (const auto& row : route_rows(folder / "out/route.csv")) {
    if (row.at(2) == "line" || row.at(2) == "cross") {
      first = row.at(2);
      EXPECT_EQ(row.at(3), "1") << "logged";
      break;
    }
  }
  EXPECT_EQ(first, "cross");
  EXPECT_NE(run.err.find("cross it"), std::string::npos) << run.err;
}

TEST(Job, ThePatchTestStandsInPlanJsonWithItsConditions) {
  const Folder folder;
  const auto run = folder.run(harbour_job("--patch-test -o out"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json tests = json_of(folder / "out/plan.json").at("job").at("patch_test");
  ASSERT_EQ(tests.size(), 4U);
  for (const json& test : tests) {
    EXPECT_FALSE(test.at("reason").get<std::string>().empty());
    bool all = !test.at("conditions").empty();
    for (const json& condition : test.at("conditions"))
      all = all && condition.at("met").get<bool>();
    EXPECT_EQ(test.at("met").get<bool>(), all);
  }
  EXPECT_NE(run.out.find("patch test:"), std::string::npos) << run.out;
}

TEST(Job, SortiesFitTheirHoursAndEachHasItsFiles) {
  const Folder folder;
  const auto run = folder.run(harbour_job(
      std::string(kBerth) + " --sortie-hours 0.3 --crs EPSG:32630 --export plan -o out"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json job = json_of(folder / "out/plan.json").at("job");
  const json& sorties = job.at("sorties");
  ASSERT_GE(sorties.size(), 2U);
  for (std::size_t k = 0; k < sorties.size(); ++k) {
    EXPECT_LE(sorties[k].at("duration_with_contingency_s").get<double>(), 0.3 * 3600.0);
    const std::string stem = "route_sortie" + std::to_string(k + 1);
    EXPECT_EQ(sorties[k].at("route"), stem + ".csv");
    const auto rows = route_rows(folder / ("out/" + stem + ".csv"));
    expect_at(rows.at(1), 150, 200);
    expect_at(rows.back(), 150, 200);
    EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + stem + ".plan")));
  }
  EXPECT_NE(run.out.find("route_sortie1.csv"), std::string::npos) << run.out;
  // A job in one piece leaves none of them behind.
  ASSERT_EQ(folder.run(harbour_job(std::string(kBerth) + " -o out")).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/route_sortie1.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/route_sortie1.plan"));
}

TEST(Job, SortiesShorterThanTheWayThereAndBackAreRefused) {
  const Folder folder;
  const auto run = folder.run(harbour_job(std::string(kBerth) + " --sortie-hours 0.01 -o out"));
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("the way from the berth to line"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--sortie-hours"), std::string::npos) << run.err;
}

TEST(Job, BadHoursAreRefused) {
  const Folder folder;
  for (const char* bad :
       {"--daylight 18:00-06:00", "--daylight noon", "--daylight 06:00-25:00", "--sortie-hours 0",
        "--battery 500", "--boats 0", "--cross-lines 0", "--cross-lines 101", "--beside-lines 3",
        "--spacing 20", "--beside 150,200", "--keep nothing.csv --beside 1,2 --spacing 3"}) {
    const auto run = folder.run(harbour_job(std::string(bad) + " -o out"));
    EXPECT_EQ(run.code, 2) << bad;
    EXPECT_NE(run.err.find("--"), std::string::npos) << bad << run.err;
  }
}

TEST(Job, TwoBoatsShareTheLinesThatWereKept) {
  const Folder folder;
  ASSERT_EQ(folder.run(harbour_job("-o one")).code, 0);
  const auto run =
      folder.run(harbour_job(std::string(kBerth) + " --keep one/route.csv --boats 2 -o two"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json plan = json_of(folder / "two/plan.json");
  EXPECT_EQ(plan.at("planner"), "kept");
  const json& boats = plan.at("job").at("boats");
  EXPECT_LE(boats.at("makespan_to_one_boat").get<double>(), 0.58);
  EXPECT_EQ(boats.at("within_a_swath_s").get<double>(), 0.0);
  EXPECT_TRUE(std::filesystem::exists(folder / "two/route_boat1.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "two/route_boat2.csv"));
  const auto logged = [&](const char* name) {
    return json_of(folder / (std::string(name) + "/score.json"))
        .at("logged_length_m")
        .get<double>();
  };
  EXPECT_NEAR(logged("two"), logged("one"), 0.03 * logged("one"));
  const auto unused = folder.run(harbour_job("--keep one/route.csv --planner nuc -o three"));
  EXPECT_EQ(unused.code, 2);
  EXPECT_THAT(unused.err, HasSubstr("--planner nuc: with --keep no planner runs"));
  const auto missing = folder.run(harbour_job("--keep nothing.csv -o three"));
  EXPECT_EQ(missing.code, 1);
  EXPECT_NE(missing.err.find("nothing.csv"), std::string::npos);
}

TEST(Job, LinesBesideAGivenOneAndAroundAPoint) {
  const Folder folder;
  folder.write("pipe.geojson", R"({"type":"LineString","coordinates":[[150,120],[150,260]]})");
  const auto along =
      folder.run("plan " + dataset("harbour.asc") +
                 " --beside pipe.geojson --beside-lines 2 --spacing 10 --profile survey "
                 "--resolution 0.5 --hit-only -o along");
  ASSERT_EQ(along.code, 0) << along.err;
  std::vector<double> eastings;
  for (const auto& row : route_rows(folder / "along/route.csv")) {
    if (row.at(2) == "line") eastings.push_back(std::stod(row.at(4)));
  }
  ASSERT_FALSE(eastings.empty());
  for (const double x : eastings) {
    EXPECT_NEAR(std::remainder(x - 150.0, 10.0), 0.0, 0.01);
    EXPECT_LE(std::abs(x - 150.0), 20.01);
  }
  const auto ring = folder.run(
      "plan " + dataset("harbour.asc") +
      " --beside 150,200 --spacing 20 --profile survey --resolution 0.5 --hit-only -o ring");
  ASSERT_EQ(ring.code, 0) << ring.err;
  for (const auto& row : route_rows(folder / "ring/route.csv")) {
    if (row.at(2) != "line") continue;
    EXPECT_NEAR(std::hypot(std::stod(row.at(4)) - 150.0, std::stod(row.at(5)) - 200.0), 20.0, 0.05);
  }
  const auto off = folder.run(
      "plan " + dataset("harbour.asc") +
      " --beside 9150,200 --spacing 20 --profile survey --resolution 0.5 --hit-only -o off");
  EXPECT_EQ(off.code, 1);
  EXPECT_NE(off.err.find("--beside 9150,200"), std::string::npos) << off.err;
}

}  // namespace
}  // namespace swathplan

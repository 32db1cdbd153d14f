#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "chart_files.h"
#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::json_of;
using test::small_chart;
using test::write_chart;
using testing::HasSubstr;

const char* const kQuick = " --planner edge-following --resolution 5 --hit-only -o out ";

std::string rectangle(double x0, double y0, double x1, double y1) {
  const auto corner = [](double x, double y) {
    return "[" + std::to_string(x) + "," + std::to_string(y) + "]";
  };
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
         R"("urn:ogc:def:crs:EPSG::32633"}},"features":[{"type":"Feature","properties":{},)"
         R"("geometry":{"type":"Polygon","coordinates":[[)" +
         corner(x0, y0) + "," + corner(x1, y0) + "," + corner(x1, y1) + "," + corner(x0, y1) + "," +
         corner(x0, y0) + "]]}}]}";
}

/// The least distance of the route from a place, metres of UTM.
double nearest(const Folder& folder, double x, double y) {
  std::istringstream lines(test::text_of(folder / "out" / "route.csv"));
  std::string line;
  std::vector<std::string> names;
  double least = 1e9;
  double last_x = 0.0;
  double last_y = 0.0;
  bool any = false;
  while (std::getline(lines, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
    if (names.empty()) {
      names = fields;
      continue;
    }
    const auto value = [&](const char* name) {
      const auto at = std::find(names.begin(), names.end(), name) - names.begin();
      return std::stod(fields.at(static_cast<std::size_t>(at)));
    };
    const double px = value("x_m");
    const double py = value("y_m");
    for (int i = 0; i <= 20; ++i) {
      const double t = any ? i / 20.0 : 1.0;
      const double qx = any ? last_x + t * (px - last_x) : px;
      const double qy = any ? last_y + t * (py - last_y) : py;
      least = std::min(least, std::hypot(qx - x, qy - y));
    }
    last_x = px;
    last_y = py;
    any = true;
  }
  return least;
}

TEST(Chart, IsPlannedClearOfItsHazards) {
  const Folder folder;
  write_chart(folder / "c.gpkg", small_chart(), 32633);
  folder.write("box.geojson", rectangle(500700, 4000000, 501200, 4000550));
  const auto run =
      folder.run(std::string("plan c.gpkg --area box.geojson --hazards LNDARE=30") + kQuick);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("2 of 2 LNDARE (buffer 30 m), 2 of 2 WRECKS (buffer 25 to 70 m)"));
  const auto plan = json_of(folder / "out" / "plan.json");
  ASSERT_EQ(plan["hazards"].size(), 2U);
  EXPECT_EQ(plan["hazards"][1]["layer"], "WRECKS");
  EXPECT_EQ(plan["hazards"][1]["near"], 2);
  EXPECT_EQ(plan["hazards"][1]["to_be_seen"], true);
  const auto drawn = json_of(folder / "out" / "hazards.geojson");
  EXPECT_EQ(drawn["features"].size(), 4U);
  EXPECT_GE(nearest(folder, 501050, 4000150), 70.0);         // the wreck
  EXPECT_GE(nearest(folder, 500900, 4000300), 50.0 + 30.0);  // the island
  EXPECT_EQ(json_of(folder / "out" / "score.json")["outside_water_m"], 0.0);
}

TEST(Chart, AWreckIsKeptOffAndStillToBeSeen) {
  const Folder folder;
  write_chart(folder / "c.gpkg", small_chart(), 32633);
  folder.write("box.geojson", rectangle(500960, 4000000, 501160, 4000240));
  const auto area = [&](const std::string& hazards) {
    const auto run = folder.run("plan c.gpkg --area box.geojson --hazards " + hazards + kQuick);
    EXPECT_EQ(run.code, 0) << run.err;
    return json_of(folder / "out" / "score.json")["survey_area_m2"].get<double>();
  };
  const double free = area("none");
  EXPECT_NEAR(free, 200.0 * 240.0, 1.0);
  EXPECT_NEAR(area("LNDARE=off"), free, 1.0);  // the wreck's cells count
  EXPECT_GE(nearest(folder, 501050, 4000150), 70.0);
  EXPECT_LT(area("LNDARE=40,WRECKS=off"), free - 100.0);  // the island's room does not
}

TEST(Chart, ABoxOnLandSaysSo) {
  const Folder folder;
  write_chart(folder / "c.gpkg", small_chart(), 32633);
  folder.write("box.geojson", rectangle(500860, 4000260, 500940, 4000340));
  const auto run = folder.run(std::string("plan c.gpkg --area box.geojson") + kQuick);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("holds no water to survey: of its 6400 m2 0 are charted water"));
}

TEST(Chart, HazardsOfAChartGoWithAnotherSeafloor) {
  const Folder folder;
  write_chart(folder / "c.gpkg", small_chart(), 32633);
  std::string soundings = "x y z\n";
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      soundings +=
          std::to_string(500960 + 10 * i) + " " + std::to_string(4000020 + 10 * j) + " -8\n";
    }
  }
  folder.write("s.xyz", soundings);
  const auto run =
      folder.run(std::string("plan s.xyz --crs EPSG:32633 --hazards c.gpkg:WRECKS") + kQuick);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_GE(nearest(folder, 501050, 4000150), 70.0);
  const auto without_crs = folder.run(std::string("plan s.xyz --hazards c.gpkg:WRECKS") + kQuick);
  EXPECT_EQ(without_crs.code, 1);
  EXPECT_THAT(without_crs.err, HasSubstr("give it with --crs"));
  const auto no_chart = folder.run(std::string("plan s.xyz --hazards WRECKS=20") + kQuick);
  EXPECT_EQ(no_chart.code, 2);
  EXPECT_THAT(no_chart.err, HasSubstr("--hazards WRECKS; names a layer of a chart"));
}

TEST(KeepOff, IsNotSailedOverAndCounts) {
  const Folder folder;
  std::string soundings = "x y z\n";
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      soundings += std::to_string(10 * i) + " " + std::to_string(10 * j) + " -8\n";
    }
  }
  folder.write("s.xyz", soundings);
  folder.write("wreck.geojson",
               R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
               R"("geometry":{"type":"Point","coordinates":[100,100]}}]})");
  const auto area = [&](const std::string& flag) {
    const auto run = folder.run("plan s.xyz " + flag + " wreck.geojson --buffer 25" + kQuick);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_GE(nearest(folder, 100, 100), 25.0) << flag;
    return json_of(folder / "out" / "score.json")["survey_area_m2"].get<double>();
  };
  EXPECT_NEAR(area("--keep-off"), 4e4, 1.0);
  EXPECT_NEAR(area("--no-go"), 4e4 - 3.14159 * 25.0 * 25.0, 20.0);
}

}  // namespace
}  // namespace swathplan

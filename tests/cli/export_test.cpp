#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::dataset;
using test::Folder;
using test::text_of;
using testing::HasSubstr;

const std::string kAll = "waypoints,plan,gpx,rtz,kml,asciiplan,lnw,rln,dxf,gpkg,yaml";

std::string plan_shaft(const std::string& more) {
  return "plan " + dataset("shaft.obj") + " --planner back-and-forth --hit-only " + more;
}

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(Export, PlanWritesAllFormatsBesideTheRoute) {
  const Folder folder;
  const auto run =
      folder.run(plan_shaft("--resolution 0.25 --crs EPSG:32630 --export " + kAll + " -o out"));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("out/route.waypoints: "));
  EXPECT_THAT(run.err, HasSubstr("from the route"));
  GDALAllRegister();
  const auto out = folder / "out";
  const auto points_of = [](const GDALDatasetUniquePtr& file) {
    return file ? file->GetLayerByName("route_points")->GetFeatureCount() : -1;
  };
  const GDALDatasetUniquePtr gpx(GDALDataset::Open((out / "route.gpx").c_str(), GDAL_OF_VECTOR));
  const auto points = points_of(gpx);
  EXPECT_GT(points, 4);
  EXPECT_EQ(count(text_of(out / "route.waypoints"), "\t3\t16\t"), points);
  EXPECT_EQ(count(text_of(out / "route.rtz"), "<waypoint "), points);
  for (const char* file : {"route.kml", "route.dxf"}) {
    EXPECT_TRUE(GDALDatasetUniquePtr(GDALDataset::Open((out / file).c_str(), GDAL_OF_VECTOR)));
  }
  EXPECT_EQ(count(text_of(out / "route.lnw"), "LIN "), count(text_of(out / "route.lnw"), "EOL"));
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << "left behind";
  }
  // The command makes them of route.csv; its micrometres may choose other waypoints of an arc.
  ASSERT_EQ(folder.run("export out/route.csv --format lnw,gpx -o again").code, 0);
  EXPECT_EQ(text_of(out / "route.lnw"), text_of(folder / "again" / "route.lnw"));
  const GDALDatasetUniquePtr again(
      GDALDataset::Open((folder / "again" / "route.gpx").c_str(), GDAL_OF_VECTOR));
  EXPECT_NEAR(static_cast<double>(points_of(again)), static_cast<double>(points), 3.0);
  // A plan without exports leaves none of an older route behind.
  ASSERT_EQ(folder.run(plan_shaft("--resolution 0.25 --crs EPSG:32630 --quiet -o out")).code, 0);
  EXPECT_FALSE(std::filesystem::exists(out / "route.waypoints"));
  EXPECT_TRUE(std::filesystem::exists(out / "route.csv"));
}

TEST(Export, LocalMetresNeverPoseAsDegrees) {
  const Folder folder;
  auto run = folder.run(plan_shaft("--export waypoints -o out"));
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("--crs EPSG:n"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "said before the work";
  ASSERT_EQ(folder.run(plan_shaft("--resolution 0.5 --export lnw,dxf -o out")).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "route.lnw"));
  run = folder.run("export out/route.csv --format gpx");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("--crs EPSG:n"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "route.gpx"));
}

TEST(Export, CompareWritesThemForEachPlanner) {
  const Folder folder;
  const auto run = folder.run("compare " + dataset("shaft.obj") +
                              " --planners back-and-forth,multi-depth --resolution 0.5 --hit-only "
                              "--crs EPSG:32630 --export gpx -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* planner : {"back-and-forth", "multi-depth"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / planner / "route.gpx"));
  }
}

TEST(Export, LinesOfOpenWaterGoToHypack) {
  const Folder folder;
  ASSERT_EQ(folder.run("synth tilted --width 300 --height 200 --slope 3 -o slope.obj").code, 0);
  const auto run = folder.run("lines slope.obj --method back-and-forth --export lnw -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto lines = test::json_of(folder / "out" / "lines.json").at("methods").at(0).at("lines");
  EXPECT_THAT(text_of(folder / "out" / "back-and-forth" / "route.lnw"),
              testing::StartsWith("LNS " + std::to_string(lines.get<int>()) + "\r\n"));
}

TEST(Export, AToleranceAndPartsAreAsAskedFor) {
  const Folder folder;
  std::ostringstream csv;
  csv << "seq,x_m,y_m,port_deg,stbd_deg\n";
  for (int i = 0; i < 400; ++i) csv << i << ',' << i << ',' << (i % 2) * 0.5 << ",60,60\n";
  folder.write("zigzag.csv", csv.str());
  const std::string command = "export zigzag.csv --crs EPSG:32630 --format waypoints ";
  auto run = folder.run(command + "--tolerance 0.1");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("400 of 400 waypoints, at most 0.000 m from the route"));
  run = folder.run(command + "--mission-items 100");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("zigzag-1.waypoints to zigzag-5.waypoints"));
  EXPECT_FALSE(std::filesystem::exists(folder / "zigzag.waypoints")) << "the older, whole one";
  run = folder.run(command + "--tolerance 1");
  EXPECT_THAT(run.out, HasSubstr("2 of 400 waypoints, at most 0.499 m"));
  EXPECT_FALSE(std::filesystem::exists(folder / "zigzag-1.waypoints"));
}

TEST(Export, BadOptionsAreNamed) {
  const Folder folder;
  folder.write("route.csv", "x,y\n0,0\n10,0\n");
  for (const auto& [more, code, said] :
       {std::tuple("--format shp", 2, "waypoints, plan, gpx"), std::tuple("", 2, "--format"),
        std::tuple("--format lnw --tolerance 0", 2, "tolerance"),
        std::tuple("--format lnw --mission-items 2", 2, "--mission-items"),
        std::tuple("--format gpx --crs EPSG:4326", 2, "--crs"),
        std::tuple("--format gpx --crs EPSG:0", 2, "--crs"),
        std::tuple("--format gpx", 1, "--crs")}) {
    const auto run = folder.run(std::string("export route.csv ") + more);
    EXPECT_EQ(run.code, code) << more << run.err;
    EXPECT_THAT(run.err, HasSubstr(said)) << more;
  }
  const auto run = folder.run("export nothing.csv --format lnw");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("nothing.csv"));
  EXPECT_EQ(folder.run(plan_shaft("--export shp -o out")).code, 2);
}

/// What logged lines cover, as `score --json` says it.
double logged_pct(const test::Run& run) {
  EXPECT_EQ(run.code, 0) << run.err;
  return nlohmann::json::parse(run.out).at("coverage_hit_logged_pct").get<double>();
}

TEST(Export, ScoredAgainWithItsLegTableItIsThePlan) {
  const Folder folder;
  ASSERT_EQ(folder.run("synth tilted -o floor.tif").code, 0);
  const std::string how =
      " --profile survey --crs EPSG:32633 --resolution 1 --turn-radius 4 --hit-only --json ";
  const double plan =
      logged_pct(folder.run("plan floor.tif --export rtz,plan,waypoints,lnw -o out" + how));
  ASSERT_GT(plan, 80.0);
  ASSERT_TRUE(std::filesystem::exists(folder / "out" / "route.legs.csv"));
  for (const char* file : {"route.rtz", "route.plan", "route.waypoints", "route.lnw"}) {
    const double again = logged_pct(folder.run("score floor.tif out/" + std::string(file) +
                                               " --legs out/route.legs.csv -o again" + how));
    EXPECT_NEAR(again, plan, 0.2) << file;
  }
  const auto other =
      folder.run("score floor.tif out/route.rtz --legs out/route.rtz -o again" + how);
  EXPECT_NE(other.code, 0);
}

}  // namespace
}  // namespace swathplan

#include <gtest/gtest.h>

#include <limits>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::dataset;
using test::Folder;
using test::Run;

/// One clear sentence on stderr, the expected exit code, nothing written.
void expect_refusal(const Folder& folder, const std::string& arguments, int code,
                    const std::vector<std::string>& words) {
  SCOPED_TRACE(arguments);
  const Run run = folder.run(arguments);
  EXPECT_EQ(run.code, code) << run.err;
  const std::size_t at = run.err.rfind("swathplan: ");
  const std::string sentence = at == std::string::npos ? run.err : run.err.substr(at);
  for (const std::string& word : words) {
    EXPECT_NE(sentence.find(word), std::string::npos)
        << "'" << word << "' is missing in: " << run.err;
  }
  EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << sentence;
  EXPECT_FALSE(std::filesystem::exists(folder / "out")) << "something was written";
}

std::string plan(const std::string& file, const std::string& options = "") {
  return "plan " + file + " --planner mdnuc -o out " + options;
}

const std::string kGridHeader =
    "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 5\nNODATA_value -9999\n";

TEST(BadSeafloor, MissingEmptyOrGarbage) {
  const Folder folder;
  expect_refusal(folder, plan("nothing.asc"), 1, {"nothing.asc"});
  folder.write("empty.asc", "");
  expect_refusal(folder, plan("empty.asc"), 1, {"empty.asc"});
  std::string garbage;
  for (int i = 0; i < 4000; ++i) garbage += static_cast<char>((i * 7919 + 13) % 251);
  for (const char* name :
       {"a.asc", "a.tif", "a.obj", "a.stl", "a.ply", "a.xyz", "a.glb", "a.bag", "a.bin"}) {
    folder.write(name, garbage);
    expect_refusal(folder, plan(name), 1, {name});
  }
  std::filesystem::create_directory(folder / "folder");
  expect_refusal(folder, plan("folder"), 1, {"folder"});
}

TEST(BadSeafloor, TruncatedFiles) {
  const Folder folder;
  folder.write("cut.asc", kGridHeader + "-5 -5 -5\n-5");
  expect_refusal(folder, plan("cut.asc"), 1, {"cut.asc"});
  folder.write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
  expect_refusal(folder, plan("cut.ply"), 1, {"cut.ply"});
  folder.write("cut.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -5\nvertex 1 0");
  expect_refusal(folder, plan("cut.stl"), 1, {"cut.stl"});
  const std::string whole = test::text_of(dataset("harbour.asc"));
  folder.write("half.asc", whole.substr(0, whole.size() / 2));
  expect_refusal(folder, plan("half.asc"), 1, {"half.asc"});
}

TEST(BadSeafloor, NotFinite) {
  const Folder folder;
  folder.write("nan.obj", "v 0 0 -5\nv 10 0 nan\nv 0 10 -5\nf 1 2 3\n");
  expect_refusal(folder, plan("nan.obj"), 1, {"nan.obj", "2"});
  folder.write("inf.xyz", "0 0 -5\n1 0 inf\n0 1 -5\n1 1 -5\n2 2 -6\n");
  expect_refusal(folder, plan("inf.xyz"), 1, {"inf.xyz"});
}

TEST(BadSeafloor, NothingToSurvey) {
  const Folder folder;
  folder.write("points.obj", "v 0 0 -5\nv 10 0 -5\nv 0 10 -5\n");
  expect_refusal(folder, plan("points.obj"), 1, {"points.obj", "face"});
  folder.write("sheet.obj", "v 0 0 -5\nv 10 0 -5\nv 10 0 -9\nv 0 0 -9\nf 1 2 3\nf 1 3 4\n");
  expect_refusal(folder, plan("sheet.obj"), 1, {"sheet.obj", "looks y up"});
  folder.write("dry.asc", kGridHeader + "5 5 5\n5 5 5\n5 5 5\n");
  expect_refusal(folder, plan("dry.asc"), 1, {"dry.asc", "--z-positive"});
  folder.write("nodata.asc",
               kGridHeader + "-9999 -9999 -9999\n-9999 -9999 -9999\n-9999 -9999 -9999\n");
  expect_refusal(folder, plan("nodata.asc"), 1, {"nodata.asc"});
  folder.write("shoal.asc", kGridHeader + "-0.5 -0.5 -0.5\n-0.5 -0.5 -0.5\n-0.5 -0.5 -0.5\n");
  expect_refusal(folder, plan("shoal.asc"), 1, {"draft"});
}

TEST(BadSeafloor, MarginThatLeavesNoWater) {
  const Folder folder;
  expect_refusal(folder, plan(dataset("harbour.asc"), "--margin 40"), 1, {"margin"});
  expect_refusal(folder, plan(dataset("saddle.asc"), "--clearance 45"), 1, {"--clearance"});
}

TEST(BadSeafloor, DegreesGivenAsMetres) {
  const Folder folder;
  folder.write(
      "degrees.asc",
      "ncols 3\nnrows 3\nxllcorner -3.5\nyllcorner 48.2\ncellsize 0.0001\nNODATA_value -9999\n"
      "-5 -5 -5\n-5 -6 -5\n-5 -5 -5\n");
  expect_refusal(folder, plan("degrees.asc", "--crs EPSG:32630"), 1, {"degrees.asc", "degrees"});
  expect_refusal(folder, plan(dataset("saddle.asc"), "--crs EPSG:99999999"), 2, {"EPSG:99999999"});
}

TEST(BadPolygons, AreaThatDoesNotFit) {
  const Folder folder;
  const auto polygon = [&](const char* name, const std::string& ring) {
    folder.write(name, R"({"type":"Polygon","coordinates":[[)" + ring + "]]}");
  };
  polygon("far.geojson", "[5000,5000],[5100,5000],[5100,5100],[5000,5000]");
  expect_refusal(folder, plan(dataset("saddle.asc"), "--area far.geojson"), 1, {"far.geojson"});
  polygon("crossed.geojson", "[-30,-30],[30,30],[30,-30],[-30,30],[-30,-30]");
  expect_refusal(folder, plan(dataset("saddle.asc"), "--area crossed.geojson"), 1,
                 {"crossed.geojson"});
  folder.write("point.geojson", R"({"type":"Point","coordinates":[0,0]})");
  expect_refusal(folder, plan(dataset("saddle.asc"), "--area point.geojson"), 1, {"point.geojson"});
  expect_refusal(folder, plan(dataset("saddle.asc"), "--no-go nothing.gpkg"), 1, {"nothing.gpkg"});
}

TEST(BadOptions, NameOptionValueAndRule) {
  const Folder folder;
  const std::string file = dataset("saddle.asc");
  expect_refusal(folder, plan(file, "--resolution 0"), 2, {"--resolution", "0"});
  expect_refusal(folder, plan(file, "--resolution -1"), 2, {"--resolution", "-1"});
  expect_refusal(folder, plan(file, "--resolution 0.00001"), 2, {"cells"});
  expect_refusal(folder, plan(file, "--beams 0"), 2, {"--beams", "0"});
  expect_refusal(folder, plan(file, "--max-opening 180"), 2, {"--max-opening", "180"});
  expect_refusal(folder, plan(file, "--depth-bands 100,200"), 2, {"--depth-bands"});
  expect_refusal(folder, plan(file, "--depth-bands 20,10"), 2, {"--depth-bands"});
  expect_refusal(folder, plan(file, "--depth-bands 0"), 2, {"--depth-bands"});
  expect_refusal(folder, plan(file, "--faces quad --face-size 0"), 2, {"--face-size", "0"});
  expect_refusal(folder, plan(file, "--ping-spacing 0"), 2, {"--ping-spacing"});
  expect_refusal(folder, plan(file, "--sonar sonic-screwdriver"), 2, {"--sonar", "norbit-iwbms"});
  expect_refusal(folder, plan(file, "--vehicle raft"), 2, {"--vehicle", "wam-v"});
  expect_refusal(folder, plan(file, "--contingency -1"), 2, {"--contingency", "-1"});
  expect_refusal(folder, plan(file, "--contingency nan"), 2, {"--contingency", "nan"});
  expect_refusal(folder, plan(file, "--start here"), 2, {"--start"});
  expect_refusal(folder, "plan " + file + " --planner magic -o out", 2, {"magic", "mdnuc"});
  expect_refusal(folder, "plan " + file + " --cover footprint --hit-only -o out", 2,
                 {"--cover", "--hit-only"});
  expect_refusal(folder, plan(file, "--resolution 1e9"), 2, {"--resolution 1e+09", "80.0 x 80.0"});
  expect_refusal(folder, plan(file, "--ping-spacing 1e6"), 2, {"--ping-spacing", "100 metres"});
  expect_refusal(folder, "plan " + file + " --heading 400 -o out", 2, {"--heading 400", "360"});
  expect_refusal(folder, plan(file, "--z-unit 100"), 1, {"range", "norbit-iwbms", "--z-unit"});
  expect_refusal(folder, "plna " + file, 2, {"'plna'", "plan, compare"});
  EXPECT_EQ(folder.run(plan(file, "--seed -1")).code, 2);
  EXPECT_EQ(folder.run("plan " + file + " -o ''").code, 2);
  EXPECT_EQ(folder.run("plan " + file + " --cover sight -o out").code, 2);
  EXPECT_EQ(folder.run(plan(file, "--faces hexagon")).code, 2);
  EXPECT_EQ(folder.run("plan").code, 2);
  EXPECT_EQ(folder.run("").code, 2);
  EXPECT_EQ(folder.run("--help").code, 0);
}

TEST(BadOutput, AFolderThatCannotBeMadeIsSaidBeforePlanning) {
  const Folder folder;
  folder.write("taken", "a file");
  const auto run = folder.run("plan " + dataset("saddle.asc") + " -o taken/out");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("taken/out"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("choices"), std::string::npos) << run.err;
}

TEST(BadLinesOptions, NameOptionValueAndRule) {
  const Folder folder;
  const std::string lines = "lines " + dataset("saddle.asc") + " -o out ";
  expect_refusal(folder, lines + "--method zigzag", 2, {"--method zigzag", "edge-following"});
  expect_refusal(folder, lines + "--max-opening 180", 2, {"--max-opening 180", "180 degrees"});
  expect_refusal(folder, lines + "--overlap 60", 2, {"--overlap 60", "40"});
  expect_refusal(folder, lines + "--missed 0", 2, {"--missed 0"});
  expect_refusal(folder, "lines nothing.asc -o out", 1, {"nothing.asc"});
}

TEST(BadRoutes, WithoutEndOrBottom) {
  const Folder folder;
  const std::string score = "score " + dataset("saddle.asc") + " ";
  expect_refusal(folder, score + "/dev/zero -o out", 1, {"/dev/zero", "no regular file"});
  expect_refusal(folder, plan("/dev/zero"), 1, {"/dev/zero", "device"});
  const std::string deep = R"({"type": "Feature", "properties": {"a": )" +
                           std::string(100000, '[') + std::string(100000, ']') + "}}";
  folder.write("deep.geojson", deep);
  expect_refusal(folder, score + "deep.geojson -o out", 1, {"deep.geojson", "100002 levels"});
  expect_refusal(folder, "export deep.geojson --format gpx -o out", 1, {"deep.geojson", "levels"});
  folder.write("deep.json", deep);
  expect_refusal(folder, plan(dataset("saddle.asc"), "--config deep.json"), 2, {"deep.json"});
}

TEST(BadRoutes, ALegFarBeyondTheDataIsScoredAndSaid) {
  const Folder folder;
  folder.write("far.csv", "x,y,port_deg,stbd_deg\n0,0,45,45\n20,0,45,45\n1e9,0,45,45\n");
  const auto result =
      folder.run("score " + dataset("saddle.asc") + " far.csv --resolution 1 -o far");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("farther from all data than the sonar's range"), std::string::npos)
      << result.err;
}

TEST(BadRoutes, NameFileAndRow) {
  const Folder folder;
  const std::string file = dataset("saddle.asc");
  const auto score = [&](const std::string& route) {
    return "score " + file + " " + route + " -o out";
  };
  expect_refusal(folder, score("nothing.csv"), 1, {"nothing.csv"});
  folder.write("one.csv", "x_m,y_m\n0,0\n");
  expect_refusal(folder, score("one.csv"), 1, {"one.csv"});
  folder.write("nan.csv", "x_m,y_m\n0,0\nnan,5\n");
  expect_refusal(folder, score("nan.csv"), 1, {"nan.csv", "3"});
  folder.write("outside.csv", "x_m,y_m\n9000,9000\n9100,9000\n");
  expect_refusal(folder, score("outside.csv"), 1, {"outside.csv"});
  folder.write("poem.csv", "roses,violets\nred,blue\n");
  expect_refusal(folder, score("poem.csv"), 1, {"poem.csv"});
  folder.write("steep.csv", "x_m,y_m,port_deg,stbd_deg\n0,0,95,40\n10,0,95,40\n");
  expect_refusal(folder, score("steep.csv"), 1, {"steep.csv"});
  folder.write("broken.geojson", R"({"type":"LineString","coordinates":[[0,0],[1)");
  expect_refusal(folder, score("broken.geojson"), 1, {"broken.geojson"});
}

}  // namespace
}  // namespace swathplan

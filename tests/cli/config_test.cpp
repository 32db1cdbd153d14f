// Options that are read back from the files that an earlier run left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kSquare =
    R"({"type":"Polygon","coordinates":[[[2,2],[48,2],[48,38],[2,38],[2,2]]]})";

void expect_same(const test::Folder& folder, const std::string& a, const std::string& b,
                 const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    EXPECT_TRUE(test::text_of(folder / a / name) == test::text_of(folder / b / name)) << name;
    EXPECT_GT(test::text_of(folder / a / name).size(), 10U) << name;
  }
}

TEST(Config, APlanIsMadeAgainFromItsOutputs) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 50 --height 40 -o flat.asc").code, 0);
  folder.write("area.geojson", kSquare);
  const auto first = folder.run(
      "plan flat.asc --planner mdnuc --resolution 0.5 --vehicle small-usv --clearance 0.2 --noise "
      "calm --seed 18446744073709551615 --depth-bands 1 --xy-unit 1 --hit-only --area area.geojson "
      "--face-size 0.9 --export dxf --quiet -o out");
  ASSERT_EQ(first.code, 0) << first.err;
  folder.write("out/area.geojson", kSquare);
  for (const std::string config : {"out/plan.json", "out/score.json", "out/survey.toml"}) {
    SCOPED_TRACE(config);
    const auto again = folder.run("plan flat.asc --quiet -o again --config " + config);
    ASSERT_EQ(again.code, 0) << again.err;
    expect_same(folder, "out", "again",
                {"plan.json", "score.json", "route.csv", "survey.toml", "route.dxf"});
  }
}

TEST(Config, WhatIsTypedGoesFirst) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 30 --height 20 -o flat.asc").code, 0);
  folder.write("survey.toml", "planner = \"back-and-forth\"\nresolution = 0.5\nhit_only = true\n");
  const auto run = folder.run("plan flat.asc --config survey.toml --resolution 1 --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto score = test::json_of(folder / "out" / "score.json");
  EXPECT_EQ(score.at("planner"), "back-and-forth");
  EXPECT_EQ(score.at("options").at("resolution_m"), 1.0);
  EXPECT_EQ(score.at("options").at("hit_only"), true);
}

TEST(Config, OneFileServesSeveralCommands) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 30 --height 20 -o flat.asc").code, 0);
  folder.write("line.csv", "x,y\n5,10\n25,10\n");
  folder.write("survey.toml", "planner = \"nuc\"\nresolution_m = 1\ndraft_m = 0.4\n");
  const auto run =
      folder.run("score flat.asc line.csv --config survey.toml --hit-only --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(test::json_of(folder / "out" / "score.json").at("options").at("draft_m"), 0.4);
}

TEST(Config, RefusalsAreOneSentence) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 30 --height 20 -o flat.asc").code, 0);
  const auto refused = [&](const std::string& text) {
    folder.write("survey.toml", text);
    const auto run = folder.run("plan flat.asc --config survey.toml -o out");
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    return run.err;
  };
  EXPECT_THAT(refused("resolutoin_m = 1\n"),
              AllOf(HasSubstr("survey.toml"), HasSubstr("resolutoin_m")));
  EXPECT_THAT(refused("resolution_m = 0\n"), HasSubstr("--resolution 0; must be above 0 metres"));
  EXPECT_THAT(refused("resolution_m = 1\nresolution = 2\n"), HasSubstr("twice"));
  EXPECT_THAT(refused("area_file = \"gone.geojson\"\n"),
              AllOf(HasSubstr("gone.geojson"), HasSubstr("beside"), HasSubstr("--area")));
}

TEST(Lines, OptionsAreRecordedAndReadAgain) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 120 --height 80 -o flat.asc").code, 0);
  const auto first = folder.run(
      "lines flat.asc --method straight --water-level 0.5 --margin 0.7 --missed 1 --quiet -o out");
  ASSERT_EQ(first.code, 0) << first.err;
  const auto options = test::json_of(folder / "out" / "lines.json").at("options");
  for (const char* name : {"crs", "water_level_m", "area_file", "no_go_file", "vehicle",
                           "under_keel_margin_m", "clearance_m", "method"}) {
    EXPECT_TRUE(options.contains(name)) << name;
  }
  const auto again = folder.run("lines flat.asc --quiet -o again --config out/survey.toml");
  ASSERT_EQ(again.code, 0) << again.err;
  expect_same(folder, "out", "again", {"lines.json", "survey.toml"});
}

TEST(BadOutput, LinesAndMissionsSayItBeforeTheWork) {
  const test::Folder folder;
  folder.write("taken", "a file");
  for (const std::string& command :
       {"lines " + test::dataset("saddle.asc"), std::string("adapt quality simulate"),
        std::string("adapt spacing study")}) {
    const auto run = folder.run(command + " -o taken/out");
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_NE(run.err.find("taken/out"), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace swathplan

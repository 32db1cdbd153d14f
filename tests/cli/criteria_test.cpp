// Surveys that are judged by a criterion before they are sailed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::json_of;
using test::text_of;
using ::testing::HasSubstr;
using ::testing::Not;

/// 40 x 40 m of level ground, 8 m deep, known each metre; data lie 10 m wider all around.
void write_floor(const Folder& folder) {
  std::string text =
      "ncols 61\nnrows 61\nxllcorner -10.5\nyllcorner -10.5\ncellsize 1\nNODATA_value -9999\n";
  for (int row = 0; row < 61; ++row) {
    for (int column = 0; column < 61; ++column) text += "-8 ";
    text += "\n";
  }
  folder.write("floor.asc", text);
  folder.write("block.geojson",
               R"({"type":"Polygon","coordinates":[[[0,0],[40,0],[40,40],[0,40],[0,0]]]})");
}

/// Lines along north, numbered and joined by legs that log nothing.
void write_lines(const Folder& folder, const std::string& name, double spacing) {
  std::string text = "line,kind,log,x_m,y_m,port_deg,stbd_deg,speed_mps\n";
  int line = 0;
  for (double x = 3.0; x < 40.0; x += spacing, ++line) {
    const bool north = line % 2 == 0;
    const std::string from = north ? "-5" : "45";
    const std::string to = north ? "45" : "-5";
    text += std::to_string(line) + ",line,1," + std::to_string(x) + "," + from + ",60,60,2\n";
    text += ",turn,0," + std::to_string(x) + "," + to + ",60,60,2\n";
  }
  folder.write(name, text);
}

const std::string kFloor = "floor.asc --area block.geojson --sonar em2040 --max-opening 130 ";
const std::string kHow = "--resolution 0.5 --ping-spacing 0.2 ";
const std::string kSensors = "--positioning rtk --motion-sensor mru ";

struct JudgedFolder : Folder {
  JudgedFolder() {
    write_floor(*this);
    write_lines(*this, "dense.csv", 10.0);
    write_lines(*this, "sparse.csv", 33.0);
  }
  [[nodiscard]] test::Run score(const std::string& lines, const std::string& options) const {
    return run("score " + kFloor + lines + " " + kHow + options + " -o out");
  }
};

TEST(CriteriaCli, AGoodSurveyIsPredictedToPass) {
  const JudgedFolder folder;
  const auto run = folder.score(
      "dense.csv", kSensors + "--criteria s44-special --smooth-seafloor --require-pass");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("predicted to pass IHO S-44 Special Order"));
  const auto criterion = json_of(folder / "out" / "score.json").at("criterion");
  EXPECT_EQ(criterion.at("predicted_to_pass"), true);
  EXPECT_EQ(criterion.at("rules").size(), 5U);
  for (const auto& rule : criterion.at("rules")) EXPECT_EQ(rule.at("pass"), true) << rule;
  const auto options = json_of(folder / "out" / "score.json").at("options");
  EXPECT_EQ(options.at("criteria"), "s44-special");
  EXPECT_EQ(options.at("roll_uncertainty_deg"), 0.05);
  EXPECT_EQ(options.at("water_level_uncertainty_m"), 0.04);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "tvu.tif"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "thu.tif"));
  EXPECT_THAT(text_of(folder / "out" / "report.html"),
              HasSubstr("predicted to pass IHO S-44 Special Order"));
}

TEST(CriteriaCli, APoorSurveyIsPredictedToFailAndExitsWithThreeWhereItMustPass) {
  const JudgedFolder folder;
  const std::string options = kSensors + "--criteria s44-1a ";
  const auto told = folder.score("sparse.csv", options);
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("predicted to fail IHO S-44 Order 1a"));
  EXPECT_THAT(told.out, HasSubstr("FAILS  coverage"));
  const auto required = folder.score("sparse.csv", options + "--require-pass --json");
  EXPECT_EQ(required.code, 3);
  EXPECT_THAT(required.err, HasSubstr("predicted to fail IHO S-44 Order 1a: coverage ("));
  const auto criterion = nlohmann::json::parse(required.out).at("criterion");
  EXPECT_EQ(criterion.at("predicted_to_pass"), false);
  EXPECT_NEAR(criterion.at("rules").at(0).at("where").at(0).at("x").get<double>(), 20.0, 3.0);
  EXPECT_EQ(criterion, json_of(folder / "out" / "score.json").at("criterion"));
}

TEST(CriteriaCli, APlanIsJudgedAsARouteIs) {
  const JudgedFolder folder;
  const auto run = folder.run("plan " + kFloor + kHow + kSensors +
                              "--planner back-and-forth --criteria s44-1a -o plan");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto again = folder.run("score " + kFloor + "plan/route.csv " + kHow + kSensors +
                                "--criteria s44-1a -o again");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json_of(folder / "plan" / "score.json").at("criterion"),
            json_of(folder / "again" / "score.json").at("criterion"));
}

TEST(CriteriaCli, WithoutACriterionNothingOfItIsWritten) {
  const JudgedFolder folder;
  ASSERT_EQ(folder.score("dense.csv", kSensors + "--criteria s44-1a").code, 0);
  ASSERT_EQ(folder.score("dense.csv", "").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "tvu.tif"));
  EXPECT_THAT(text_of(folder / "out" / "score.json"), Not(HasSubstr("criteri")));
}

TEST(CriteriaCli, IsTheSameForAnyNumberOfThreads) {
  const JudgedFolder folder;
  std::vector<std::string> texts;
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(folder.score("dense.csv", kSensors + "--criteria s44-1a --threads " + threads).code,
              0);
    texts.push_back(text_of(folder / "out" / "score.json") + text_of(folder / "out" / "tvu.tif"));
  }
  EXPECT_EQ(texts[0], texts[1]);
}

/// A run that ends with `code` and says so.
void expect_refused(const test::Run& run, int code, const std::string& why) {
  EXPECT_EQ(run.code, code);
  EXPECT_THAT(run.err, HasSubstr(why));
}

TEST(CriteriaCli, RefusesASigmaThatNobodyGave) {
  const JudgedFolder folder;
  expect_refused(folder.score("dense.csv", "--criteria s44-1a"), 2,
                 "not given: --roll-uncertainty, --pitch-uncertainty");
  expect_refused(
      folder.score("dense.csv", "--criteria s44-1a --positioning dgnss --motion-sensor ins"), 2,
      "not given: --water-level-uncertainty; give it");
  EXPECT_EQ(folder
                .score("dense.csv",
                       "--criteria s44-1a --positioning dgnss --motion-sensor ins "
                       "--water-level-uncertainty 0.05")
                .code,
            0);
}

TEST(CriteriaCli, RefusesAPlanWhereNoSoundingCanBeAccepted) {
  const JudgedFolder folder;
  expect_refused(folder.run("plan " + kFloor + kHow + kSensors +
                            "--planner back-and-forth --criteria s44-1a "
                            "--water-level-uncertainty 0.5 -o plan"),
                 2,
                 "not even the beam straight down is known well enough in 8.0 m of water: TVU 0.99 "
                 "m (limit 0.51 m)");
}

TEST(CriteriaCli, RefusesCellsFinerThanTheData) {
  const JudgedFolder folder;
  expect_refused(folder.score("dense.csv", kSensors + "--criteria s44-special"), 2,
                 "--criteria s44-special; it judges cells of 0.5 m and the seafloor is known by "
                 "points 1 m apart");
}

TEST(CriteriaCli, RefusesWhatHasNoUseWithoutACriterion) {
  const JudgedFolder folder;
  expect_refused(folder.score("dense.csv", "--require-pass"), 2,
                 "--require-pass without --criteria");
  expect_refused(folder.score("dense.csv", "--roll-uncertainty 0.1"), 2,
                 "--roll-uncertainty without --criteria");
}

TEST(CriteriaCli, RefusesValuesThatBreakTheirRules) {
  const JudgedFolder folder;
  expect_refused(folder.score("dense.csv", "--criteria s44"), 2, "--criteria s44; must be none, ");
  expect_refused(folder.score("dense.csv", kSensors + "--criteria s44-1a --pitch-uncertainty -1"),
                 2, "--pitch-uncertainty -1; must be 0 degrees or more");
  expect_refused(folder.score("dense.csv", "--criteria s44-1a --positioning loran"), 2,
                 "--positioning loran; must be none, gnss");
}

}  // namespace
}  // namespace swathplan

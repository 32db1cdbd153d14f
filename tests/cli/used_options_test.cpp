// Options that the chosen planner or command does not use are refused, not ignored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

class UsedOptions : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(folder_.run("synth flat --width 60 --height 40 -o flat.asc").code, 0);
    folder_.write("line.csv", "x,y\n5,10\n55,10\n");
  }
  std::string refused(const std::string& arguments) {
    const auto run = folder_.run(arguments);
    EXPECT_EQ(run.code, 2) << arguments << "\n" << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << arguments;
    return run.err;
  }
  test::Folder folder_;
};

TEST_F(UsedOptions, APlannerThatDoesNotUseOneNamesThoseThatDo) {
  const auto plan = [&](const std::string& options) {
    return refused("plan flat.asc --resolution 1 -o out --planner " + options);
  };
  EXPECT_THAT(plan("edge-following --heading 30"),
              HasSubstr("--heading 30; edge-following does not use it: leave it out, or choose "
                        "back-and-forth, multi-depth or fitted-lines"));
  EXPECT_THAT(plan("back-and-forth --coverage 98"), HasSubstr("or choose fitted-lines"));
  EXPECT_THAT(plan("back-and-forth --length 900"), HasSubstr("--length 900"));
  EXPECT_THAT(plan("nuc --time 1"), HasSubstr("--time 1"));
  EXPECT_THAT(plan("nuc --depth-bands 3"), HasSubstr("multi-depth or mdnuc"));
  EXPECT_THAT(plan("mdnuc --line-margin 5"), HasSubstr("edge-following or fitted-lines"));
  EXPECT_THAT(plan("fitted-lines --faces quad"), HasSubstr("--faces quad"));
}

TEST_F(UsedOptions, ACommandThatDoesNotHaveOneNamesThoseThatDo) {
  EXPECT_THAT(refused("inspect flat.asc --area a.geojson"),
              HasSubstr("--area; 'inspect' does not use it, but plan, compare, lines, score"));
  EXPECT_THAT(refused("score flat.asc line.csv -o out --heading=30"),
              HasSubstr("--heading; 'score'"));
  EXPECT_THAT(refused("lines flat.asc -o out --beams 100"), HasSubstr("--beams; 'lines'"));
  EXPECT_THAT(refused("lines flat.asc -o out --method field --heading 10"),
              HasSubstr("auto, straight or back-and-forth"));
  EXPECT_THAT(refused("synth saddle -o saddle.asc --width 10"),
              HasSubstr("--width 10; saddle does not use it"));
}

TEST_F(UsedOptions, CompareRefusesOnlyWhatNoneOfItsPlannersUses) {
  const std::string compare = "compare flat.asc --resolution 1 --hit-only --quiet -o out ";
  EXPECT_THAT(refused(compare + "--planners nuc,mdnuc --heading 30"),
              HasSubstr("nuc, mdnuc do not use it"));
  const auto run = folder_.run(compare + "--planners nuc,back-and-forth --heading 30");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(UsedOptions, AConfigurationFileMayHoldWhatOtherPlannersUse) {
  folder_.write("boat.toml", "heading_deg = 30\ngoal_coverage_pct = 98\nresolution_m = 1\n");
  const auto run = folder_.run("plan flat.asc --planner nuc --config boat.toml --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto again = folder_.run("plan flat.asc --config out/survey.toml --quiet -o again");
  EXPECT_EQ(again.code, 0) << again.err;
}

}  // namespace
}  // namespace swathplan

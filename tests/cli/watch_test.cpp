// What a terminal shows of long work, and what Ctrl-C does to it.
#include <gmock/gmock.h>

#include <filesystem>

#include "cli/program.h"
#include "cli/terminal_run.h"

namespace swathplan::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A second is promised; a machine that builds beside it may take as long again, and a sanitizer.
constexpr double kSoon = 3.0;

/// A plan whose search takes tens of seconds.
std::vector<std::string> long_plan(const std::string& folder) {
  return {"plan", dataset("harbour.asc"), "--resolution", "0.25", "-o", folder};
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.push_back(fs::relative(entry.path(), folder).string());
  }
  return names;
}

TEST(Watch, ShowsPhaseTriedBestGoneAndLeftAndCtrlCKeepsTheBest) {
  const Folder folder;
  TerminalRun run(folder.path(), long_plan("out"));
  ASSERT_TRUE(run.shows(" gone")) << run.shown();
  EXPECT_LT(run.seconds(), kSoon);
  ASSERT_TRUE(run.shows("searching: 1 of ")) << run.shown();
  ASSERT_TRUE(run.shows(" left | best ")) << run.shown();
  run.press_ctrl_c();
  EXPECT_TRUE(run.shows("Ctrl-C: ending with the best so far")) << run.shown();
  ASSERT_EQ(run.code(), 0) << run.shown();
  EXPECT_THAT(run.shown(), HasSubstr("note: search ended early: the best of the "));
  for (const char* name : {"route.csv", "route.local.geojson", "score.json", "plan.json",
                           "coverage.tif", "coverage.png", "report.html", "survey.toml"}) {
    EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
  }
  EXPECT_THAT(json_of(folder / "out" / "plan.json")["notes"].dump(),
              HasSubstr("search ended early"));
  EXPECT_THAT(text_of(folder / "out" / "report.html"), HasSubstr("search ended early"));
  EXPECT_GT(json_of(folder / "out" / "score.json")["coverage_hit_logged_pct"].get<double>(), 50.0);
}

TEST(Watch, ASecondCtrlCStopsAtOnceAndLeavesNothing) {
  const Folder folder;
  TerminalRun run(folder.path(), long_plan("out"));
  ASSERT_TRUE(run.shows(" | best ")) << run.shown();
  run.press_ctrl_c();
  ASSERT_TRUE(run.shows("Ctrl-C: ending")) << run.shown();
  const double pressed = run.seconds();
  run.press_ctrl_c();
  EXPECT_EQ(run.code(), 130) << run.shown();
  EXPECT_LT(run.seconds() - pressed, kSoon);
  EXPECT_THAT(files_in(folder / "out"), IsEmpty());
}

TEST(Watch, CtrlCStopsAtOnceWhereNothingIsSearched) {
  const Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 300 --height 300 -o flat.asc").code, 0);
  folder.write("route.csv", "x_m,y_m\n10,10\n290,10\n290,290\n10,290\n10,20\n280,20\n");
  TerminalRun run(folder.path(), {"score", "flat.asc", "route.csv", "--resolution", "0.05",
                                  "--ping-spacing", "0.002", "-o", "out"});
  ASSERT_TRUE(run.shows("scoring")) << run.shown();
  run.press_ctrl_c();
  EXPECT_EQ(run.code(), 130) << run.shown();
  EXPECT_THAT(files_in(folder / "out"), IsEmpty());
}

TEST(Watch, AComparisonThatIsEndedNamesThePlannersThatItLeftOut) {
  const Folder folder;
  TerminalRun run(folder.path(), {"compare", dataset("harbour.asc"), "--resolution", "0.25",
                                  "--planners", "fitted-lines,nuc", "-o", "out"});
  ASSERT_TRUE(run.shows(" | best ")) << run.shown();
  run.press_ctrl_c();
  ASSERT_EQ(run.code(), 0) << run.shown();
  EXPECT_THAT(run.shown(), HasSubstr("NUC is left out: the search ended early"));
  EXPECT_EQ(json_of(folder / "out" / "compare.json").size(), 1U);
  EXPECT_TRUE(fs::exists(folder / "out/fitted-lines/plan.json"));
  EXPECT_TRUE(fs::exists(folder / "out/report.html"));
}

TEST(Watch, AStudyThatIsEndedGoesOnWhereItWas) {
  const Folder folder;
  const std::vector<std::string> study{"adapt", "accordion", "study", "--missions",
                                       "3000",  "-o",        "out"};
  {
    TerminalRun run(folder.path(), study);
    ASSERT_TRUE(run.shows("study accordion-")) << run.shown();
    ASSERT_TRUE(run.shows(" left")) << run.shown();
    run.press_ctrl_c();
    ASSERT_EQ(run.code(), 130) << run.shown();
    EXPECT_THAT(run.shown(), HasSubstr("cells of the study are done and kept in "));
  }
  const auto names = files_in(folder / "out");
  ASSERT_EQ(names.size(), 1U);
  EXPECT_THAT(names[0], HasSubstr(".journal"));
  const std::string kept = text_of(folder / "out" / names[0]);
  TerminalRun again(folder.path(), study);
  ASSERT_TRUE(again.shows(" left")) << again.shown();
  again.press_ctrl_c();
  ASSERT_EQ(again.code(), 130);
  const std::string more = text_of(folder / "out" / names[0]);
  EXPECT_GT(more.size(), kept.size());
}

TEST(Watch, IsSilentWhereNobodyLooksOrAsks) {
  const Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 60 --height 40 -o flat.asc").code, 0);
  const std::vector<std::string> plan{"plan",         "flat.asc", "--planner", "back-and-forth",
                                      "--resolution", "1",        "-o",        "out"};
  std::vector<std::string> quiet = plan;
  quiet.emplace_back("--quiet");
  TerminalRun run(folder.path(), quiet);
  EXPECT_EQ(run.code(), 0) << run.shown();
  EXPECT_THAT(run.shown(), Not(HasSubstr("\x1b")));
  const auto piped =
      folder.run("plan flat.asc --planner back-and-forth --resolution 1 --ping-spacing 1 -o out");
  EXPECT_EQ(piped.code, 0);
  EXPECT_THAT(piped.err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(piped.err, Not(HasSubstr(" gone")));
}

}  // namespace
}  // namespace swathplan::test

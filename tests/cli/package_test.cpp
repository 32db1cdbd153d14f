// What comes with the installed program.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace swathplan {
namespace {

using test::Folder;
using test::text_of;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Version, NamesTheProgramAndItsLibraries) {
  const Folder folder;
  const auto run = folder.run("--version");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("swathplan "));
  for (const char* library : {"assimp", "Boost", "CGAL", "CLI11", "Clipper", "Eigen", "Embree",
                              "fmt", "GDAL", "Ipopt", "JSON", "oneTBB", "OpenCV", "PROJ"}) {
    EXPECT_THAT(run.out, ContainsRegex(std::string(library) + " +[0-9]+\\.[0-9]+"));
  }
}

/// The output of a shell command in the folder; fails the test if it ends with an error.
std::string shell(const Folder& folder, const std::string& command) {
  const std::string out = (folder / ".shell").string();
  const std::string all =
      "cd '" + folder.path().string() + "' && { " + command + "; } >'" + out + "' 2>&1";
  EXPECT_EQ(std::system(all.c_str()), 0) << command;
  return text_of(out);
}

TEST(Manual, HasAPageForEachCommandThatGroffTakes) {
  const Folder folder;
  ASSERT_EQ(folder.run("man -o manual").code, 0);
  for (const char* name : {"swathplan", "swathplan-plan", "swathplan-adapt-spacing-live"}) {
    EXPECT_THAT(text_of(folder / "manual" / "man1" / (std::string(name) + ".1")),
                StartsWith(".\\\""))
        << name;
  }
  EXPECT_EQ(shell(folder, "for page in manual/man1/*; do groff -man -Tutf8 -ww -z $page; done"),
            "");
  EXPECT_THAT(folder.run("--help").out, Not(HasSubstr("manual pages")));
}

/// What bash would offer behind these words.
std::string completed(const Folder& folder, const std::string& words) {
  return shell(folder,
               "bash -c 'source manual/completions/swathplan; compopt() { :; }; COMP_WORDS=(" +
                   words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _swathplan; "
                   "echo -n \"${COMPREPLY[*]}\"'");
}

TEST(Completion, OffersCommandsOptionsAndTheWordsOfAnOption) {
  const Folder folder;
  ASSERT_EQ(folder.run("man -o manual").code, 0);
  EXPECT_EQ(completed(folder, "swathplan sc"), "score");
  EXPECT_EQ(completed(folder, "swathplan adapt \"\""), "accordion spacing quality --help");
  EXPECT_EQ(completed(folder, "swathplan adapt spacing st"), "study");
  EXPECT_EQ(completed(folder, "swathplan plan a.asc --no-"), "--no-go");
  EXPECT_EQ(completed(folder, "swathplan plan a.asc --cover \"\""), "hit footprint");
  EXPECT_EQ(completed(folder, "swathplan plan a.asc --area \"\""), "") << "bash completes files";
}

}  // namespace
}  // namespace swathplan

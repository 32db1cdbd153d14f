#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

using testing::HasSubstr;

std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("swathplan-adapt-" + name + "-" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

struct Outcome {
  int code = -1;
  std::vector<std::string> lines;  // of stdout and stderr
};

Outcome run(const std::string& arguments, const std::string& input = "") {
  const auto folder = scratch("input");
  std::ofstream(folder / "in") << input;
  const std::string command = std::string(SWATHPLAN_PROGRAM) + " adapt " + arguments + " < " +
                              (folder / "in").string() + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> buffer{};
  while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
    outcome.lines.emplace_back(buffer.data());
  }
  outcome.code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

constexpr const char* kSmall = "--width 200 --length 100 --spacing 50 -o ";

std::string cost(int track, double ahead) {
  std::ostringstream line;
  const bool outbound = track % 2 == 0;
  const auto side = [&](double value) {
    std::ostringstream s;
    s << R"({"step_m":25,"rows":[[0.1,)" << value << "]]}";
    return s.str();
  };
  line << R"({"track":)" << track << R"(,"port":)" << side(outbound ? 0.1 : ahead)
       << R"(,"starboard":)" << side(outbound ? ahead : 0.1) << "}\n";
  return line.str();
}

TEST(AdaptLive, AccordionFoldsOnAnObjectAndEnds) {
  const auto folder = scratch("live");
  const auto outcome = run("accordion live " + (kSmall + folder.string()),
                           cost(0, 1.0) + cost(1, 0.1) + cost(2, 0.1));
  ASSERT_EQ(outcome.code, 0);
  ASSERT_EQ(outcome.lines.size(), 4U);
  EXPECT_THAT(outcome.lines[0], HasSubstr(R"("track":0,"across_m":0.0)"));
  EXPECT_THAT(outcome.lines[1], HasSubstr(R"("track":1,"across_m":50.0)"));
  EXPECT_THAT(outcome.lines[2], HasSubstr(R"("track":2,"across_m":150.0)"));
  EXPECT_THAT(outcome.lines[3], HasSubstr(R"("type":"done","tracks":3)"));
  EXPECT_THAT(contents(folder / "route.csv"), HasSubstr("seq,line,kind,log"));
  EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
}

TEST(AdaptLive, LostAndMalformedLinesDoNotEndTheMission) {
  const auto folder = scratch("live-bad");
  const std::string input = "{\"track\":0,\n" + std::string("\xff\xfe garbage\n") + "[1,2]\n\n" +
                            R"({"track":"zero"})" + "\n" + cost(3, 0.1) +
                            R"({"track":0,"port":{"step_m":25,"rows":[[0.1,null]]}})" + "\n" +
                            R"({"track":0})" + "\n" + R"({"repeat":true})" + "\n" + cost(0, 0.1) +
                            cost(0, 0.1) + cost(1, 0.1) + cost(2, 0.1) + cost(3, 0.1);
  const auto outcome = run("accordion live " + (kSmall + folder.string()), input);
  ASSERT_EQ(outcome.code, 0);
  ASSERT_EQ(outcome.lines.size(), 14U);
  for (const std::size_t i : {1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
    EXPECT_THAT(outcome.lines[i], HasSubstr(R"("type":"error")")) << i;
    EXPECT_THAT(outcome.lines[i], HasSubstr(R"("due":0)")) << i;
  }
  EXPECT_THAT(outcome.lines[5], HasSubstr("never given"));
  EXPECT_EQ(outcome.lines[8], outcome.lines[0]);  // repeated
  EXPECT_THAT(outcome.lines[9], HasSubstr(R"("track":1)"));
  EXPECT_THAT(outcome.lines[10], HasSubstr("observed already"));
  EXPECT_THAT(outcome.lines[11], HasSubstr(R"("track":2)"));
  EXPECT_THAT(outcome.lines[12], HasSubstr(R"("type":"done")"));
  EXPECT_THAT(outcome.lines[13], HasSubstr("complete"));
}

TEST(AdaptLive, SpacingTakesCurvesAndCounts) {
  const auto folder = scratch("live-spacing");
  const auto outcome = run(
      "spacing live --as-published -o " + folder.string(),
      R"({"track":0,"curve":{"range_m":[40,70,130],"p":[0.2,0.5,0.05]}})"
      "\n"
      R"({"track":1,"counts":{"first_m":40,"step_m":30,"trials":[9,9,9,9],"detections":[3,6,2,0]}})"
      "\n"
      R"({"track":2,"curve":{"range_m":[40,30],"p":[0.2,0.5]}})"
      "\n");
  ASSERT_EQ(outcome.code, 0);
  ASSERT_EQ(outcome.lines.size(), 4U);
  EXPECT_THAT(outcome.lines[0], HasSubstr(R"("across_m":138.0)"));
  EXPECT_THAT(outcome.lines[1], HasSubstr(R"("across_m":236.0)"));
  EXPECT_THAT(outcome.lines[2], HasSubstr(R"("track":2)"));
  EXPECT_THAT(outcome.lines[3], HasSubstr("sort the ranges"));
}

TEST(AdaptLive, QualityRefusesTheWrongLength) {
  const auto folder = scratch("live-quality");
  const auto outcome = run("quality live --width 200 --length 300 -o " + folder.string(),
                           R"({"track":0,"port":[1,1],"starboard":[1,1]})"
                           "\n");
  ASSERT_EQ(outcome.code, 0);
  ASSERT_EQ(outcome.lines.size(), 2U);
  EXPECT_THAT(outcome.lines[1], HasSubstr("give 11"));
}

TEST(AdaptLive, ErrorsSayWhatIsWrongInPlainWords) {
  const auto folder = scratch("live-words");
  const auto outcome = run("quality live --width 200 --length 300 -o " + folder.string(),
                           "{\"track\":0,\"port\":[NaN]}\n"
                           "{\"track\":0,\"port\":[null],\"starboard\":[1]}\n"
                           "{\"track\":0,\"starboard\":[1]}\n"
                           "{\"track\":99999999999999999999}\n");
  ASSERT_EQ(outcome.code, 0);
  ASSERT_EQ(outcome.lines.size(), 5U);
  EXPECT_THAT(outcome.lines[1], HasSubstr("the line is not JSON"));
  EXPECT_THAT(outcome.lines[2], HasSubstr("must be number, but is null"));
  EXPECT_THAT(outcome.lines[3], HasSubstr("'port' not found"));
  EXPECT_THAT(outcome.lines[4], HasSubstr("whole number"));
  for (const auto& line : outcome.lines) EXPECT_THAT(line, testing::Not(HasSubstr("exception")));
}

TEST(AdaptLive, AMissingImageIsAnswered) {
  const auto folder = scratch("live-image");
  const auto outcome = run("accordion live " + (kSmall + folder.string()),
                           "{\"track\":0,\"image\":\"no-such.png\"}\n" + cost(0, 0.1));
  ASSERT_EQ(outcome.lines.size(), 3U);
  EXPECT_THAT(outcome.lines[1], HasSubstr("no-such.png is no file"));
  EXPECT_THAT(outcome.lines[2], HasSubstr(R"("track":1)"));
}

TEST(AdaptCommand, BadOptionsAreUsageErrors) {
  for (const char* arguments :
       {"spacing simulate --range 100", "spacing simulate --width 20",
        "spacing simulate --nadir -3", "spacing simulate --threshold 1.5",
        "quality simulate --turn-width -3", "quality simulate --constraint strict",
        "quality simulate --width 100", "accordion simulate --nadir-gap 50",
        "accordion simulate --width 0", "accordion simulate --p-obj 1.5",
        "accordion simulate --rule brave", "accordion simulate --start-corner north"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.lines.size(), 1U) << arguments;
  }
}

TEST(AdaptCommand, BadCurveFilesAreDataErrors) {
  const auto folder = scratch("curve");
  for (const char* text : {"", "range_m,p\n", "40,0.5\n30,0.4\n", "40,1.5\n", "40,-0.1\n",
                           "40,0.5\nnonsense\n", "40,nan\n", "40;0.5\n"}) {
    std::ofstream(folder / "curve.csv") << text;
    const auto outcome = run("spacing simulate --curve " + (folder / "curve.csv").string());
    EXPECT_EQ(outcome.code, 1) << text;
    ASSERT_EQ(outcome.lines.size(), 1U) << text;
    EXPECT_THAT(outcome.lines[0], HasSubstr("curve.csv"));
  }
}

// Interrupted anywhere, on any number of threads: the same bytes in the end.
TEST(AdaptStudy, ResumesToTheSameResult) {
  const auto whole = scratch("study-whole");
  const auto torn = scratch("study-torn");
  const std::string study = "accordion study --missions 1 --quiet --threads ";
  ASSERT_EQ(run(study + "1 -o " + whole.string()).code, 0);
  const std::string journal = contents(whole / "accordion-basic.journal");
  std::ofstream(torn / "accordion-basic.journal") << journal.substr(0, journal.size() / 3);
  ASSERT_EQ(run(study + "2 -o " + torn.string()).code, 0);
  const std::string csv = contents(whole / "accordion-basic.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 148);
  EXPECT_EQ(contents(torn / "accordion-basic.csv"), csv);
  EXPECT_TRUE(std::filesystem::exists(torn / "accordion-basic.png"));
  const auto other = run(study + "2 --seed 2 -o " + torn.string());
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.lines.at(0), HasSubstr("other settings"));
}

// Killed in the midst of its work, as by a power cut: nothing but finished cells is left, and the
// same command ends with the bytes of a study that was never disturbed.
TEST(AdaptStudy, SurvivesBeingKilled) {
  const auto whole = scratch("study-undisturbed");
  const auto killed = scratch("study-killed");
  const std::string study = "quality study --width 600 --missions 2 --quiet -o ";
  ASSERT_EQ(run(study + whole.string()).code, 0);
  const std::string journal = (killed / "quality.journal").string();
  const std::string script = std::string(SWATHPLAN_PROGRAM) + " adapt " + study + killed.string() +
                             " & pid=$!; until [ \"$(wc -l < " + journal +
                             " 2>/dev/null || echo 0)\" -ge 4 ]; do kill -0 $pid || break; done "
                             "2>/dev/null; kill -9 $pid 2>/dev/null; wait $pid 2>/dev/null; true";
  ASSERT_EQ(std::system(script.c_str()), 0);
  const std::string left = contents(journal);
  EXPECT_GE(std::count(left.begin(), left.end(), '\n'), 4);
  ASSERT_EQ(run(study + killed.string()).code, 0);
  EXPECT_EQ(contents(killed / "quality.csv"), contents(whole / "quality.csv"));
  EXPECT_EQ(contents(killed / "quality.png"), contents(whole / "quality.png"));
}

}  // namespace

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

// A flat bottom as a grid of 5 m.
void write_flat_grid(const std::filesystem::path& file, int columns, int rows) {
  std::ofstream out(file);
  out << "ncols " << columns << "\nnrows " << rows
      << "\nxllcorner 0\nyllcorner 0\ncellsize 5\nNODATA_value -9999\n";
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) out << (c > 0 ? " " : "") << "-20";
    out << "\n";
  }
}

std::vector<std::string> places_across(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    const auto at = line.find("\"across_m\":");
    if (at != std::string::npos) result.push_back(line.substr(at, line.find(',', at) - at));
  }
  return result;
}

// Images of `simulate` lead `live` along the same tracks, over empty ground and with objects.
TEST(AdaptLive, ImagesOfSimulateAreSailedAlike) {
  const auto folder = scratch("live-images");
  write_flat_grid(folder / "flat.asc", 50, 22);
  for (const char* rule : {"basic", "bounded"}) {
    const std::string shape = "--width 200 --length 60 --spacing 40 --nadir-gap 5 --rule " +
                              std::string(rule) + " --pixel 0.2 -o " + folder.string();
    const auto sim = run("accordion simulate " + (folder / "flat.asc").string() +
                         " --corner 20,20 --objects 0 --ping-spacing 0.4 --quiet " + shape);
    ASSERT_EQ(sim.code, 0) << (sim.lines.empty() ? "" : sim.lines[0]);
    const std::string journal = contents(folder / "mission.json");
    std::string messages;
    std::size_t images = 0;
    for (; images < 20; ++images) {
      std::ostringstream name;
      name << "waterfall-00" << images << ".png";
      if (images > 9 || !std::filesystem::exists(folder / name.str())) break;
      messages += "{\"track\":" + std::to_string(images) + ",\"image\":\"" +
                  (folder / name.str()).string() + "\",\"nadir\":\"clear\"}\n";
    }
    EXPECT_THAT(journal, HasSubstr("\"tracks\": " + std::to_string(images)));
    const auto live = run("accordion live --row 0.4 " + shape, messages);
    ASSERT_EQ(live.lines.size(), images + 1) << rule;
    EXPECT_THAT(live.lines.back(), HasSubstr(R"("type":"done")"));
    EXPECT_EQ(places_across(live.lines).size(), images);
    // Without a gap filler the strips below the tracks are not taken for seen.
    std::string blind = messages;
    for (auto at = blind.find(",\"nadir\":\"clear\""); at != std::string::npos;
         at = blind.find(",\"nadir\":\"clear\"")) {
      blind.erase(at, std::string(",\"nadir\":\"clear\"").size());
    }
    const auto unfilled = run("accordion live --row 0.4 " + shape, blind);
    EXPECT_THAT(unfilled.lines.back(), testing::Not(HasSubstr(R"("type":"done")"))) << rule;
    for (std::size_t i = 0; i < images; ++i) {
      std::ostringstream name;
      name << "waterfall-00" << i << ".png";
      std::filesystem::remove(folder / name.str());
    }
  }
}

TEST(AdaptLive, ImagesAndMapsMustSpanTrackAndStrip) {
  const auto folder = scratch("live-span");
  const std::string options = "accordion live " + (kSmall + folder.string());
  const auto outcome = run(
      options,
      R"({"track":0,"port":{"step_m":50,"row_m":1,"rows":[[0.1]]},"starboard":{"step_m":50,"rows":[[0.1]]}})"
      "\n"
      R"({"track":0,"port":{"first_m":49,"step_m":1,"rows":[[0.1]]},"starboard":{"step_m":50,"rows":[[0.1]]}})"
      "\n" +
          cost(0, 0.1));
  ASSERT_EQ(outcome.lines.size(), 4U);
  EXPECT_THAT(outcome.lines[1], HasSubstr("span 1 m along the track"));
  EXPECT_THAT(outcome.lines[2], HasSubstr("begins 49 m from the track"));
  EXPECT_THAT(outcome.lines[3], HasSubstr(R"("track":1)"));
}

TEST(AdaptLive, AnObservationWithRepeatIsTaken) {
  const auto folder = scratch("live-repeat");
  std::string first = cost(0, 0.1);
  first.insert(1, "\"repeat\":true,");
  const auto outcome =
      run("accordion live " + (kSmall + folder.string()), first + first + cost(1, 0.1));
  ASSERT_EQ(outcome.lines.size(), 4U);
  EXPECT_THAT(outcome.lines[1], HasSubstr(R"("track":1)"));
  EXPECT_EQ(outcome.lines[2], outcome.lines[1]);  // it was taken already
  EXPECT_THAT(outcome.lines[3], HasSubstr(R"("track":2)"));
}

TEST(AdaptLive, SpacingTellsADeadSide) {
  const auto folder = scratch("live-sides");
  const std::string alive = R"({"curve":{"range_m":[40,70,150],"p":[0.2,0.5,0.1]}})";
  const std::string dead = R"({"curve":{"range_m":[40,150],"p":[0,0]}})";
  std::string input;
  for (int i = 0; i < 40; ++i) {
    input +=
        "{\"track\":" + std::to_string(i) + ",\"port\":" + alive + ",\"starboard\":" + dead + "}\n";
  }
  const auto outcome = run("spacing live --range 150 -o " + folder.string(), input);
  const auto done = std::find_if(outcome.lines.begin(), outcome.lines.end(), [](const auto& l) {
    return l.find("\"done\"") != std::string::npos;
  });
  ASSERT_NE(done, outcome.lines.end());
  EXPECT_THAT(*done, HasSubstr(R"("range_too_short":true)"));
  EXPECT_THAT(*done, HasSubstr(R"("uncovered_pct":)"));
  const auto half =
      run("spacing live -o " + folder.string(), "{\"track\":0,\"port\":" + alive + "}\n");
  EXPECT_THAT(half.lines.at(1), HasSubstr("'starboard' not found"));
}

TEST(AdaptLive, ADeadSonarEndsWithNothingGained) {
  const auto folder = scratch("live-dead");
  std::string input;
  for (int i = 0; i < 30; ++i) {
    input += "{\"track\":" + std::to_string(i) +
             R"(,"port":[0,0,0,0,0,0,0,0,0,0,0],"starboard":[0,0,0,0,0,0,0,0,0,0,0]})" + "\n";
  }
  const auto outcome = run("quality live --width 600 --length 300 -o " + folder.string(), input);
  EXPECT_THAT(outcome.lines.at(8), HasSubstr(R"("status":"nothing gained")"));
}

TEST(AdaptCommand, NarrowSwathsNeedNoOptimum) {
  const auto folder = scratch("narrow");
  const auto outcome =
      run("quality simulate --swath 2.5 --width 500 --length 300 -o " + folder.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(contents(folder / "mission.json"), testing::Not(HasSubstr("optimal_tracks")));
}

TEST(AdaptCommand, MissionsGoRoundNoGoAreas) {
  const auto folder = scratch("no-go");
  write_flat_grid(folder / "flat.asc", 50, 22);
  std::ofstream(folder / "no-go.geojson")
      << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
      << R"({"type":"Polygon","coordinates":[[[15,40],[25,40],[25,50],[15,50],[15,40]]]}}]})";
  const std::string simulate =
      "accordion simulate " + (folder / "flat.asc").string() +
      " --corner 20,20 --objects 0 --width 200 --length 60 --spacing 40 --pixel 0.4 "
      "--ping-spacing 0.5 --quiet -o " +
      folder.string();
  const auto outcome = run(simulate + " --no-go " + (folder / "no-go.geojson").string());
  ASSERT_EQ(outcome.code, 0) << (outcome.lines.empty() ? "" : outcome.lines[0]);
  EXPECT_THAT(contents(folder / "mission.json"), HasSubstr("12 m of 1 track lie in no-go areas"));
  EXPECT_THAT(contents(folder / "mission.json"), HasSubstr("(track 0)"));
  EXPECT_THAT(contents(folder / "score.json"), HasSubstr(R"("infeasible_m": 0)"));
  EXPECT_THAT(contents(folder / "route.csv"), testing::Not(HasSubstr("infeasible")));
  const auto area = run(simulate + " --area " + (folder / "no-go.geojson").string());
  EXPECT_EQ(area.code, 2);
  EXPECT_THAT(area.lines.at(0), HasSubstr("--area; the box is the survey area"));
}

TEST(AdaptCommand, AbstractMissionsGoRoundNoGoAreas) {
  const auto folder = scratch("abstract-no-go");
  const auto write =
      [&](const char* name, const std::string& ring) {
        std::ofstream(folder / name)
            << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},)"
            << R"("geometry":{"type":"Polygon","coordinates":[)" << ring << "]}}]}";
        return " --no-go " + (folder / name).string();
      };
  const std::string middle = write("middle.geojson", "[[40,40],[210,40],[210,60],[40,60],[40,40]]");
  for (const char* mission : {"accordion simulate --width 250 --length 100 --spacing 50 --p-obj 0",
                              "spacing simulate --width 250 --length 100 --range 80 --nadir 20",
                              "quality simulate --width 250 --length 100"}) {
    const auto outcome = run(mission + middle + " --quiet -o " + folder.string());
    ASSERT_EQ(outcome.code, 0) << mission << (outcome.lines.empty() ? "" : outcome.lines[0]);
    EXPECT_THAT(contents(folder / "mission.json"), HasSubstr("are not sailed (track"));
    EXPECT_THAT(contents(folder / "score.json"), HasSubstr(R"("infeasible_m": 0)")) << mission;
  }
  const auto missed = run("quality simulate --width 250 --length 100 -o " + folder.string() +
                          write("far.geojson", "[[9000,100],[9100,100],[9100,200],[9000,100]]"));
  EXPECT_EQ(missed.code, 1);
  EXPECT_THAT(missed.lines.at(0), HasSubstr("do not meet"));
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
  for (const char* setting : {"--seed 2", "--nadir-gap 5", "--clearance 2", "--spacing 40"}) {
    const auto other = run(study + "2 " + setting + " -o " + torn.string());
    EXPECT_EQ(other.code, 2) << setting;
    EXPECT_THAT(other.lines.at(0), HasSubstr("other settings")) << setting;
  }
  // It makes its own areas.
  for (const char* unused : {"--width 500", "--length 500", "--threshold 1"}) {
    EXPECT_EQ(run(study + "2 " + unused + " -o " + torn.string()).code, 2) << unused;
  }
}

TEST(AdaptStudy, RefusesWhatItDoesNotUse) {
  const auto folder = scratch("study-unused");
  for (const char* unused : {"spacing study --range 100", "spacing study --azimuth 10",
                             "quality study --constraint mild", "quality study --corner 1 2"}) {
    EXPECT_EQ(run(std::string(unused) + " -o " + folder.string()).code, 2) << unused;
  }
}

TEST(AdaptStudy, QualityLeavesTheOptimumOutWhereSwathsAreTooNarrowForIt) {
  const auto folder = scratch("study-narrow");
  const auto outcome =
      run("quality study --width 300 --length 300 --swath 2 --missions 1 --quiet -o " +
          folder.string());
  ASSERT_EQ(outcome.code, 0) << outcome.lines.at(0);
  const std::string csv = contents(folder / "quality.csv");
  EXPECT_EQ(csv.find("optimal_tracks"), std::string::npos);
  EXPECT_NE(csv.find("preplanned_covered_pct"), std::string::npos);
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

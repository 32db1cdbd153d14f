// Line spacing, overlap, fan and speeds as surveyors type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "cli/program.h"

namespace swathplan {
namespace {

using testing::HasSubstr;

struct Row {
  std::map<std::string, std::string> cells;
  [[nodiscard]] double number(const std::string& name) const { return std::stod(cells.at(name)); }
};

std::vector<Row> rows_of(const std::filesystem::path& csv) {
  std::ifstream in(csv);
  std::string line;
  const auto split = [](const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
      if (c == ',')
        parts.emplace_back();
      else if (c != '\r')
        parts.back() += c;
    }
    return parts;
  };
  std::getline(in, line);
  const auto names = split(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const auto cells = split(line);
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row.cells[names[i]] = cells.at(i);
    rows.push_back(row);
  }
  return rows;
}

/// Distances across the course of 30 degrees between neighbouring lines.
std::vector<double> spacings(const std::vector<Row>& rows, double heading_deg) {
  const double a = heading_deg * std::acos(-1.0) / 180.0;
  std::map<int, double> across;
  for (const Row& row : rows) {
    if (row.cells.at("kind") != "line") continue;
    across[std::stoi(row.cells.at("line"))] =
        row.number("x_m") * std::cos(a) - row.number("y_m") * std::sin(a);
  }
  std::vector<double> places, gaps;
  for (const auto& [line, place] : across) places.push_back(place);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) gaps.push_back(places[i] - places[i - 1]);
  return gaps;
}

TEST(SurveyorsOptions, SpacingAndHeadingAreWhatTheLinesHave) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 400 --height 300 --depth 12 -o flat.asc").code, 0);
  const auto run = folder.run(
      "plan flat.asc --profile survey --planner back-and-forth --resolution 2 --spacing 45 "
      "--heading 30 --speed '4 kn' --hit-only -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto rows = rows_of(folder / "out" / "route.csv");
  const auto gaps = spacings(rows, 30.0);
  ASSERT_GE(gaps.size(), 5U);
  for (const double gap : gaps) EXPECT_NEAR(gap, 45.0, 0.01);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (rows[i].cells.at("kind") != "line" ||
        rows[i + 1].cells.at("line") != rows[i].cells.at("line"))
      continue;
    const double east = rows[i + 1].number("x_m") - rows[i].number("x_m");
    const double north = rows[i + 1].number("y_m") - rows[i].number("y_m");
    EXPECT_NEAR(std::abs(east / north), std::tan(std::acos(-1.0) / 6.0), 1e-3);
    EXPECT_NEAR(rows[i].number("speed_mps"), 4.0 * 1852.0 / 3600.0, 1e-3);
    EXPECT_NEAR(rows[i].number("port_deg"), 65.0, 1e-6);
  }
  const auto again = folder.run("plan flat.asc --config out/survey.toml --quiet -o again");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(test::text_of(folder / "out/route.csv"), test::text_of(folder / "again/route.csv"));
}

TEST(SurveyorsOptions, CoarseCellsDoNotSpreadTheLines) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 200 --height 200 --depth 8 -o flat.asc").code, 0);
  const auto lines = [&](const std::string& options) {
    const auto run = folder.run(
        "plan flat.asc --planner back-and-forth --resolution 1 --heading 0 "
        "--hit-only -o out " +
        options);
    EXPECT_EQ(run.code, 0) << run.err;
    return spacings(rows_of(folder / "out/route.csv"), 0.0);
  };
  // By hand: 2 x 7.7 m below the sonar x tan 60 less 20 %.
  const double by_hand = 0.8 * 2.0 * 7.7 * std::tan(std::acos(-1.0) / 3.0);
  const auto gaps = lines("--profile survey --overlap 20 --opening-angle 120");
  ASSERT_GE(gaps.size(), 7U);
  for (const double gap : gaps) EXPECT_NEAR(gap, by_hand, 0.01);
  const auto score = test::json_of(folder / "out/score.json");
  EXPECT_GT(score.at("coverage_hit_logged_pct").get<double>(), 95.0);
  EXPECT_EQ(score.at("options").at("overlap_pct"), 20.0);
  EXPECT_TRUE(lines("--profile paper").empty()) << "W = 256 m: one line";
}

TEST(SurveyorsOptions, AreRefusedOneSentenceEach) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 100 --height 100 -o flat.asc").code, 0);
  const auto refused = [&](const std::string& options) {
    const auto run = folder.run("plan flat.asc --resolution 2 -o out " + options);
    EXPECT_EQ(run.code, 2) << options << run.err;
    const std::string sentence =
        run.err.substr(std::min(run.err.find("swathplan: "), run.err.size()));
    EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << options;
    return sentence;
  };
  const std::string rows = "--profile survey --planner back-and-forth ";
  EXPECT_THAT(refused(rows + "--overlap 100"),
              HasSubstr("--overlap 100; must be at least 0 and under 100"));
  EXPECT_THAT(refused(rows + "--spacing 0"), HasSubstr("--spacing 0"));
  EXPECT_THAT(refused(rows + "--spacing 0.001"), HasSubstr("--spacing"));
  EXPECT_THAT(refused(rows + "--spacing 20 --overlap 5"), HasSubstr("exclude each other"));
  EXPECT_THAT(refused(rows + "--spacing-depth deepest"), HasSubstr("--spacing-depth deepest"));
  EXPECT_THAT(refused(rows + "--spacing-depth p100"), HasSubstr("p99"));
  EXPECT_THAT(refused(rows + "--opening-angle 150"), HasSubstr("--max-opening, 130 degrees"));
  EXPECT_THAT(refused(rows + "--speed fast"), HasSubstr("4kn"));
  EXPECT_THAT(refused(rows + "--speed 0kn"), HasSubstr("--speed 0; must be above 0 m/s"));
  EXPECT_THAT(refused("--profile paper --planner back-and-forth --spacing 20"),
              HasSubstr("--swath-by fan"));
  EXPECT_THAT(
      refused("--profile survey --spacing 20"),
      HasSubstr(
          "fitted-lines does not use it: leave it out, or choose back-and-forth or multi-depth"));
}

TEST(SurveyorsOptions, SpeedsInAConfigurationFileMayNameTheirUnit) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 60 --height 60 -o flat.asc").code, 0);
  folder.write("boat.toml",
               "speed_mps = \"5.4 kn\"\nturn_speed_mps = \"3.6km/h\"\ntransit-speed = \"2m/s\"\n");
  const auto run = folder.run(
      "plan flat.asc --planner back-and-forth --resolution 2 --hit-only "
      "--quiet --config boat.toml -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto options = test::json_of(folder / "out/score.json").at("options");
  EXPECT_NEAR(options.at("speed_mps").get<double>(), 2.778, 1e-9);
  EXPECT_NEAR(options.at("turn_speed_mps").get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(options.at("transit_speed_mps").get<double>(), 2.0, 1e-9);
}

TEST(SurveyorsOptions, AFixedFanHoldsForFittedLinesToo) {
  const test::Folder folder;
  ASSERT_EQ(folder.run("synth flat --width 80 --height 60 --depth 10 -o flat.asc").code, 0);
  const auto run = folder.run(
      "plan flat.asc --profile survey --resolution 1 --opening-angle 100 "
      "--hit-only --quiet -o out");
  ASSERT_EQ(run.code, 0) << run.err;
  std::size_t lines = 0;
  for (const Row& row : rows_of(folder / "out/route.csv")) {
    if (row.cells.at("log") != "1") continue;
    ++lines;
    EXPECT_NEAR(row.number("port_deg"), 50.0, 1e-6);
    EXPECT_NEAR(row.number("stbd_deg"), 50.0, 1e-6);
  }
  EXPECT_GT(lines, 1U);
}

}  // namespace
}  // namespace swathplan

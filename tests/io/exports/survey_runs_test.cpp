#include "io/exports/survey_runs.h"

#include <gtest/gtest.h>

#include <set>

#include "io/sample_route.h"

namespace swathplan {
namespace {

TEST(SurveyRuns, AreTheLinesInTheirOrder) {
  const Route route = test::lawnmower(3);
  const std::vector<SurveyRun> runs = survey_runs(route);
  ASSERT_EQ(runs.size(), 3U);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].name, std::to_string(i + 1));
    const Vec2 along =
        route.waypoints[runs[i].last].position - route.waypoints[runs[i].first].position;
    EXPECT_NEAR(along.norm(), 100.0, 1e-9);
  }
}

TEST(SurveyRuns, NamesAreUnique) {
  Route route = test::lawnmower(4);
  for (Waypoint& w : route.waypoints) {
    if (w.line == 3) w.line = 1;
    if (w.line == 4) w.line = std::nullopt;
  }
  const std::vector<SurveyRun> runs = survey_runs(route);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[2].name, "1_2");
  EXPECT_EQ(runs[3].name, "3");
}

TEST(WaypointNames, TellStartsAndEndsOfLines) {
  Route route = test::lawnmower(2);
  std::vector<std::string> names = waypoint_names(route);
  EXPECT_EQ(names[0], "line 1 start");
  EXPECT_EQ(names[1], "2");
  EXPECT_EQ(names[200], "line 1 end");
  EXPECT_EQ(names[260], "line 2 start");
  EXPECT_EQ(names.back(), "line 2 end");
  for (Waypoint& w : route.waypoints) {
    if (w.kind != LegKind::turn) continue;
    w.kind = LegKind::line;
    w.line = 7;
  }
  names = waypoint_names(route);
  EXPECT_EQ(names[200], "line 1 end, line 7 start");
}

TEST(WaypointNames, TellCrossAndPatchLinesFromTheMainScheme) {
  Route route = test::lawnmower(3);
  for (Waypoint& w : route.waypoints) {
    if (w.line == 1 && is_survey(w.kind)) w.kind = LegKind::patch;
    if (w.line == 2 && is_survey(w.kind)) w.kind = LegKind::cross;
  }
  const std::vector<SurveyRun> runs = survey_runs(route);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].name, "P1");
  EXPECT_EQ(runs[1].name, "X2");
  EXPECT_EQ(runs[2].name, "3");
  const std::vector<std::string> names = waypoint_names(route);
  EXPECT_EQ(names[runs[0].first], "patch line P1 start");
  EXPECT_EQ(names[runs[1].last], "cross-line X2 end");
  EXPECT_EQ(short_waypoint_names(route)[runs[1].first], "SX2");
}

TEST(WaypointNames, ShortOnesAreUniqueWithinSixCharacters) {
  Route route = test::lawnmower(130);
  for (Waypoint& w : route.waypoints) {
    if (w.line == 99) w.line = 1;  // a second stretch: '1_2'
  }
  const std::vector<std::string> names = short_waypoint_names(route);
  EXPECT_EQ(names[0], "S1");
  EXPECT_EQ(names[200], "E1");
  EXPECT_EQ(names.back(), "E130");
  for (const std::string& name : names) EXPECT_LE(name.size(), 6U) << name;
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (Waypoint& w : route.waypoints) {  // each line begins where the one before it ends
    if (w.kind == LegKind::turn) w.kind = LegKind::line;
  }
  const std::vector<std::string> joined = short_waypoint_names(route);
  EXPECT_EQ(std::set<std::string>(joined.begin(), joined.end()).size(), joined.size());
}

}  // namespace
}  // namespace swathplan

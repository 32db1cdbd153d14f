#include "planners/job/job_line.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

void expect_same(const std::vector<Waypoint>& a, const std::vector<Waypoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT((a[i].position - b[i].position).norm(), 1e-9) << i;
    EXPECT_EQ(a[i].kind, b[i].kind) << i;
    EXPECT_EQ(a[i].fan, b[i].fan) << i;
    EXPECT_EQ(a[i].speed_mps, b[i].speed_mps) << i;
  }
}

TEST(JobLine, ARouteIsItsLinesWithTheirJoins) {
  const JobSite bench;
  const Route route = bench.rows(4);
  const std::vector<JobLine> lines = job_lines(route, bench.how.vehicle.turn_radius_m);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(lines[0].join_before.empty());
  double seconds = 0.0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_EQ(lines[k].points.front().line, static_cast<int>(k) + 1);
    seconds += sailing_s(lines[k].points);
    if (k == 0) continue;
    ASSERT_FALSE(lines[k].join_before.empty());
    EXPECT_EQ(lines[k].join_before.front().position, lines[k - 1].points.back().position);
    std::vector<Waypoint> join = lines[k].join_before;
    join.push_back(lines[k].points.front());
    seconds += sailing_s(join);
  }
  EXPECT_NEAR(seconds, sailing_s(route.waypoints), 1e-6);
}

// A file of lines alone, as a survey package plans them: its reader joins them by straights.
TEST(JobLine, AStraightFromLineToLineIsNoJoinToKeep) {
  const JobSite bench;
  Route route;
  for (int k = 0; k < 3; ++k) {
    const JobLine line = bench.northward(50.0 + 25.0 * k, k + 1);
    const auto points = k % 2 == 0 ? line.points : backwards(line).points;
    route.waypoints.insert(route.waypoints.end(), points.begin(), points.end());
    route.waypoints.back().kind = LegKind::transit;
    route.waypoints.back().log = false;
    route.waypoints.back().line.reset();
  }
  route.waypoints.back().kind = LegKind::end;
  const std::vector<JobLine> lines = job_lines(route, bench.how.vehicle.turn_radius_m);
  ASSERT_EQ(lines.size(), 3U);
  for (const JobLine& line : lines) EXPECT_TRUE(line.join_before.empty());
}

TEST(JobLine, BackwardsChangesSidesRunsAndCoursesAndTwiceBackIsTheSame) {
  const JobSite bench;
  JobLine line = bench.northward(100, 7);
  line.points.insert(line.points.begin(), line.points.front());
  line.points[0].kind = LegKind::run_in;
  line.points[0].log = false;
  line.points[0].position -= Vec2(0, 20);
  line.points[0].speed_mps = 1.0;
  const JobLine back = backwards(line);
  ASSERT_EQ(back.points.size(), 3U);
  EXPECT_EQ(back.points.front().position, line.points.back().position);
  EXPECT_EQ(back.points[0].kind, LegKind::line);
  EXPECT_EQ(back.points[1].kind, LegKind::run_out);
  EXPECT_EQ(back.points[1].speed_mps, 1.0);
  EXPECT_EQ(back.points[0].fan->port, bench.fan.starboard);
  EXPECT_EQ(back.points[0].fan->starboard, bench.fan.port);
  EXPECT_NEAR(sailing_s(back.points), sailing_s(line.points), 1e-9);
  const JobLine again = backwards(back);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    EXPECT_EQ(again.points[i].kind, line.points[i].kind);
    EXPECT_EQ(again.points[i].speed_mps, line.points[i].speed_mps);
    EXPECT_EQ(again.points[i].fan, line.points[i].fan);
  }
}

TEST(JobLine, APlanTurnedRoundKeepsItsJoins) {
  const JobSite bench;
  const std::vector<JobLine> lines = job_lines(bench.rows(3), bench.how.vehicle.turn_radius_m);
  const std::vector<JobLine> back = backwards(lines);
  ASSERT_EQ(back.size(), 3U);
  EXPECT_TRUE(back[0].join_before.empty());
  EXPECT_EQ(back[1].join_before.size(), lines[2].join_before.size());
  EXPECT_LT((back[1].join_before.front().position - back[0].points.back().position).norm(), 1e-9);
  // As arranged in the opposite order.
  const auto same = arranged(lines, {{2, true}, {1, true}, {0, true}});
  for (std::size_t k = 0; k < 3; ++k) {
    expect_same(same[k].points, back[k].points);
    expect_same(same[k].join_before, back[k].join_before);
  }
  // Out of order there is no join to keep.
  for (const JobLine& line : arranged(lines, {{0, false}, {2, false}, {1, true}})) {
    EXPECT_TRUE(line.join_before.empty());
  }
}

TEST(JobLine, PiecesTakeTheSameTimeAndMakeUpTheLine) {
  const JobSite bench;
  JobLine line = bench.northward(100, 1);
  line.points.insert(line.points.begin() + 1, line.points[0]);
  line.points[1].position = {100, 150};
  line.points[1].speed_mps = 0.5;
  const std::vector<JobLine> pieces = divided(line, 5);
  ASSERT_EQ(pieces.size(), 5U);
  double length = 0.0;
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(sailing_s(pieces[k].points), sailing_s(line.points) / 5.0, 1e-6);
    length += length_m({pieces[k].points});
    if (k == 0) continue;
    EXPECT_EQ(pieces[k].points.front().position, pieces[k - 1].points.back().position);
  }
  EXPECT_NEAR(length, 200.0, 1e-9);
  EXPECT_EQ(divided(line, 1).size(), 1U);
}

TEST(JobLine, PurposeIsThatOfTheWholeLine) {
  const JobSite bench;
  JobLine line = bench.northward(100, 1);
  EXPECT_EQ(purpose(line), LegKind::line);
  for (Waypoint& w : line.points) w.kind = LegKind::cross;
  EXPECT_EQ(purpose(line), LegKind::cross);
  for (Waypoint& w : line.points) w.kind = LegKind::patch;
  EXPECT_EQ(purpose(line), LegKind::patch);
}

}  // namespace
}  // namespace swathplan

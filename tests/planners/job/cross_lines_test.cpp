#include "planners/job/cross_lines.h"

#include <gtest/gtest.h>

#include <set>

#include "coverage/route/cross_figures.h"
#include "mesh/base/error.h"
#include "planners/job/job_site.h"

namespace swathplan {
namespace {

CrossLines laid(const JobSite& bench, const std::vector<JobLine>& main, double share) {
  return cross_lines(main, bench.site.ground, bench.how, bench.connector,
                     {.share = share, .first_number = 50});
}

TEST(CrossLines, HaveTheShareAskedForAtRightAnglesToTheMainLines) {
  const JobSite bench;
  const std::vector<JobLine> main =
      job_lines(bench.rows(20), bench.how.vehicle.turn_radius_m);  // 4 km
  const CrossLines found = laid(bench, main, 0.05);
  EXPECT_GE(found.share, 0.05 - 1e-9);
  EXPECT_LT(found.share, 0.06);
  ASSERT_FALSE(found.lines.empty());
  int number = 50;
  for (const JobLine& line : found.lines) {
    EXPECT_EQ(line.points[0].kind, LegKind::cross);
    EXPECT_TRUE(line.points[0].log);
    EXPECT_EQ(line.points[0].line, number++);
    const Vec2 way = line.points[1].position - line.points[0].position;
    EXPECT_NEAR(way.y(), 0.0, 1e-6) << "main lines run north";
    EXPECT_GE(way.norm(), bench.how.least_line_m);
  }
}

TEST(CrossLines, AreSpreadOverTheMainLinesBeforeOneIsCrossedTwice) {
  const JobSite bench;
  const std::vector<JobLine> main = job_lines(bench.rows(20), bench.how.vehicle.turn_radius_m);
  const CrossLines found = laid(bench, main, 0.06);  // 240 m: half of the lines once
  std::set<double> seen;
  std::size_t crossings = 0;
  for (const JobLine& line : found.lines) {
    for (const JobLine& other : main) {
      const double x = other.points[0].position.x();
      const double a = line.points[0].position.x();
      const double b = line.points[1].position.x();
      if ((x - a) * (x - b) > 0.0) continue;
      seen.insert(x);
      ++crossings;
    }
  }
  EXPECT_GE(seen.size(), 8U);
  EXPECT_LE(crossings, seen.size() + 1);
}

TEST(CrossLines, AvoidSteepGround) {
  // A shelf, a slope of 25 degrees in the middle third, a deep plain.
  Seafloor floor = flat(600, 400, 20);
  for (Vec3& v : floor.vertices) {
    v.z() -= std::clamp(v.y() - 180.0, 0.0, 60.0) * std::tan(25.0 * 3.14159265 / 180.0);
  }
  const JobSite bench(std::move(floor));
  const CrossLines found =
      laid(bench, job_lines(bench.rows(20), bench.how.vehicle.turn_radius_m), 0.05);
  ASSERT_FALSE(found.lines.empty());
  EXPECT_LT(found.median_slope_deg, 1.0);
  for (const JobLine& line : found.lines) {
    const double y = line.points[0].position.y();
    EXPECT_TRUE(y < 185.0 || y > 235.0) << y;
  }
  EXPECT_GE(found.depth_tenths, 2U);
}

TEST(CrossLines, ThereAreNoneWhereNothingCanBeCrossed) {
  const JobSite bench;
  EXPECT_TRUE(laid(bench, {}, 0.05).lines.empty());
  EXPECT_THROW(static_cast<void>(laid(bench, {}, 0.0)), UsageError);
  EXPECT_THROW(static_cast<void>(laid(bench, {}, 1.1)), UsageError);
}

}  // namespace
}  // namespace swathplan

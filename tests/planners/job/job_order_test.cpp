#include "planners/job/job_order.h"

#include <gtest/gtest.h>

#include "planners/job/job_site.h"

namespace swathplan {
namespace {

TEST(JobOrder, ARoundTripFromTheBerthTakesLessTimeThanTheGivenOrder) {
  const JobSite bench;
  std::vector<JobLine> lines;
  for (const double x : {50.0, 450.0, 150.0, 350.0, 250.0, 550.0}) {
    lines.push_back(bench.northward(x, static_cast<int>(x)));
  }
  JobEnds ends;
  ends.out = ends.home = Vec2(300, 20);
  const auto given = in_given_order(lines, bench.ways, ends);
  const auto best = in_best_order(lines, bench.ways, ends);
  ASSERT_EQ(best.size(), lines.size());
  EXPECT_LT(estimated_s(best, bench.ways, ends), 0.8 * estimated_s(given, bench.ways, ends));
  // No round trip over six lines from a berth south of them needs less than once along and back.
  const double lines_s = 6.0 * 200.0 / bench.how.vehicle.speed_mps;
  const double ways_s = 2.0 * 500.0 / bench.how.vehicle.transit_speed_mps;
  EXPECT_GT(estimated_s(best, bench.ways, ends), lines_s + ways_s);
}

TEST(JobOrder, TheGivenOrderIsTurnedRoundWhereThatIsNearer) {
  const JobSite bench;
  const std::vector<JobLine> lines = job_lines(bench.rows(5), bench.how.vehicle.turn_radius_m);
  JobEnds ends;
  ends.out = Vec2(200, 250);
  const auto turned = in_given_order(lines, bench.ways, ends);
  EXPECT_EQ(turned.front().points.front().line, 5);
  EXPECT_FALSE(turned[1].join_before.empty());
  ends.out = Vec2(20, 100);
  EXPECT_EQ(in_given_order(lines, bench.ways, ends).front().points.front().line, 1);
}

}  // namespace
}  // namespace swathplan

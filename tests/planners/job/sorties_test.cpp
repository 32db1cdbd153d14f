#include "planners/job/sorties.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/base/error.h"
#include "planners/job/job_site.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

const Vec2 kQuay(300, 20);

double estimate(const JobSite& bench, const SortieLines& lines) {
  JobEnds ends;
  ends.out = ends.home = kQuay;
  return estimated_s(lines, bench.ways, ends);
}

std::size_t lines_in(const std::vector<SortieLines>& sorties) {
  std::size_t count = 0;
  for (const SortieLines& s : sorties) count += s.size();
  return count;
}

TEST(Sorties, EachFitsItsHoursWithWholeLinesInTheirOrder) {
  const JobSite bench;
  const std::vector<JobLine> lines = job_lines(bench.rows(16), bench.how.vehicle.turn_radius_m);
  const double whole = estimate(bench, lines);
  const double longest = whole / 3.0;
  const auto sorties = cut_into_sorties(lines, bench.ways, kQuay, longest);
  EXPECT_GE(sorties.size(), 4U);
  EXPECT_EQ(lines_in(sorties), lines.size());
  double together = 0.0;
  int number = 1;
  for (const SortieLines& s : sorties) {
    EXPECT_LE(estimate(bench, s), longest);
    together += estimate(bench, s);
    for (const JobLine& line : s) EXPECT_EQ(line.points.front().line, number++);
  }
  // Each cut costs a way home and out again, 360 m at most, less the join that it saves.
  const double way = 2.0 * 390.0 / bench.how.vehicle.transit_speed_mps;
  EXPECT_LT(together, whole + static_cast<double>(sorties.size() - 1) * way);
}

TEST(Sorties, OneSortieIsEnoughWhereThereIsTimeForAll) {
  const JobSite bench;
  const std::vector<JobLine> lines = job_lines(bench.rows(4), bench.how.vehicle.turn_radius_m);
  EXPECT_EQ(cut_into_sorties(lines, bench.ways, kQuay, 1e5).size(), 1U);
  EXPECT_TRUE(cut_into_sorties({}, bench.ways, kQuay, 1e5).empty());
}

TEST(Sorties, ALineThatDoesNotFitIsDivided) {
  const JobSite bench;
  // 400 m to the east at 2 m/s, the ends 100 s from the berth and more.
  JobLine line = bench.northward(300, 1);
  line.points[0].position = {100, 60};
  line.points[1].position = {500, 60};
  const auto sorties = cut_into_sorties({line}, bench.ways, kQuay, 270.0);
  EXPECT_GE(sorties.size(), 2U);
  double surveyed = 0.0;
  for (const SortieLines& s : sorties) {
    EXPECT_LE(estimate(bench, s), 270.0);
    for (const JobLine& piece : s) surveyed += sailing_s(piece.points);
  }
  EXPECT_NEAR(surveyed, 200.0, 1e-6);
}

TEST(Sorties, ShorterThanTheWayThereAndBackIsRefused) {
  const JobSite bench;
  const std::string message = message_of<UsageError>([&] {
    static_cast<void>(cut_into_sorties({bench.northward(300, 9)}, bench.ways, kQuay, 60.0));
  });
  EXPECT_THAT(message, testing::AllOf(testing::HasSubstr("line 9"), testing::HasSubstr("0.02 h"),
                                      testing::HasSubstr("<sortie hours>")));
}

TEST(Sorties, BoatsGetAboutTheSameTime) {
  const JobSite bench;
  const std::vector<JobLine> lines = job_lines(bench.rows(15), bench.how.vehicle.turn_radius_m);
  for (const int boats : {2, 3}) {
    const auto parts = cut_for_boats(lines, bench.ways, kQuay, boats);
    ASSERT_EQ(parts.size(), static_cast<std::size_t>(boats));
    double longest = 0.0, shortest = 1e9;
    for (const SortieLines& part : parts) {
      longest = std::max(longest, estimate(bench, part));
      shortest = std::min(shortest, estimate(bench, part));
    }
    EXPECT_LT(longest - shortest, 150.0) << "a line and its join";
  }
}

TEST(Sorties, OneLongLineIsSharedByTwoBoats) {
  const JobSite bench;
  const auto parts = cut_for_boats({bench.northward(300, 1)}, bench.ways, kQuay, 2);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_FALSE(parts[0].empty());
  EXPECT_FALSE(parts[1].empty());
}

}  // namespace
}  // namespace swathplan

#include "planners/job/whole_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "coverage/route/route_figures.h"
#include "mesh/base/error.h"
#include "planners/job/job_site.h"
#include "planners/message_of.h"

namespace swathplan {
namespace {

const Vec2 kBerth(300, 20);

Job made(const JobSite& bench, const Route& main, const JobOptions& how) {
  return whole_job(main, bench.site.ground, bench.how, how);
}

std::set<int> main_lines(const Route& route) {
  std::set<int> numbers;
  for (const Waypoint& w : route.waypoints) {
    if (w.line && w.kind == LegKind::line) numbers.insert(*w.line);
  }
  return numbers;
}

TEST(WholeJob, FromTheBerthAndBackWithAllLinesInSafeWater) {
  const JobSite bench;
  const Route main = bench.rows(6);
  const Job job = made(bench, main, {.berth = kBerth});
  EXPECT_FALSE(fault(job.route)) << *fault(job.route);
  EXPECT_EQ(job.route.waypoints.front().position, kBerth);
  EXPECT_EQ(job.route.waypoints.back().position, kBerth);
  EXPECT_EQ(main_lines(job.route), main_lines(main));
  EXPECT_EQ(job.routes.size(), 1U);
  const RouteFigures figures = route_figures(job.route, bench.how.vehicle, bench.site.ground.water,
                                             bench.site.depths, 1.0, 1.0);
  EXPECT_LT(figures.outside_water_m, 1e-3);
  EXPECT_EQ(figures.infeasible_legs, 0U);
}

TEST(WholeJob, PatchTestThenCrossLinesThenTheMainScheme) {
  const JobSite bench;
  const Job job =
      made(bench, bench.rows(10), {.berth = kBerth, .cross_share = 0.05, .patch_test = true});
  std::vector<LegKind> kinds;
  for (const Waypoint& w : job.route.waypoints) {
    if (is_survey(w.kind) && (kinds.empty() || kinds.back() != w.kind)) kinds.push_back(w.kind);
  }
  EXPECT_EQ(kinds, (std::vector<LegKind>{LegKind::patch, LegKind::cross, LegKind::line}));
  const CrossFigures cross = cross_figures(job.route);
  EXPECT_GE(cross.share(), 0.05 - 1e-9);
  EXPECT_EQ(cross.right_angled, cross.crossings);
  EXPECT_EQ(job.summary.patch_tests.size(), 4U);
}

TEST(WholeJob, LinesThatARouteHasAlreadyAreKeptFirst) {
  const JobSite bench;
  const Job first =
      made(bench, bench.rows(10), {.berth = kBerth, .cross_share = 0.05, .patch_test = true});
  const Job again = made(bench, first.route, {.berth = Vec2(20, 380), .cross_share = 0.05});
  EXPECT_EQ(again.routes.size(), 1U);
  EXPECT_NEAR(cross_figures(again.route).length_m, cross_figures(first.route).length_m, 1.0);
  std::vector<LegKind> kinds;
  for (const Waypoint& w : again.route.waypoints) {
    if (is_survey(w.kind) && (kinds.empty() || kinds.back() != w.kind)) kinds.push_back(w.kind);
  }
  EXPECT_EQ(kinds, (std::vector<LegKind>{LegKind::patch, LegKind::cross, LegKind::line}));
  EXPECT_THAT(again.notes, testing::Contains(testing::HasSubstr("cross-lines already")));
}

TEST(WholeJob, EverySortieFitsItsHoursWithContingency) {
  const JobSite bench;
  const Route main = bench.rows(20);
  const Job job = made(bench, main, {.berth = kBerth, .longest_sortie_s = 1500.0});
  ASSERT_GE(job.routes.size(), 2U);
  EXPECT_EQ(job.summary.sorties.size(), job.routes.size());
  for (std::size_t k = 0; k < job.routes.size(); ++k) {
    const JobSortie& sortie = job.summary.sorties[k];
    EXPECT_LE(sortie.with_contingency_s, 1500.0);
    EXPECT_NEAR(sortie.duration_s, sailing_s(job.routes[k].waypoints), 1e-6);
    EXPECT_EQ(job.routes[k].waypoints.front().position, kBerth);
    EXPECT_EQ(job.routes[k].waypoints.back().position, kBerth);
    EXPECT_FALSE(fault(job.routes[k])) << *fault(job.routes[k]);
  }
  EXPECT_EQ(main_lines(job.route), main_lines(main));
  // Cuts are made where a way home costs little more than the way on.
  EXPECT_LT(job.summary.sailed_s, 1.15 * job.summary.undivided_s);
  EXPECT_NEAR(job.summary.sailed_s, sailing_s(job.route.waypoints), 0.1);
}

TEST(WholeJob, DaylightPutsSortiesOnDaysOfTheirOwn) {
  const JobSite bench;
  const Job job = made(bench, bench.rows(20),
                       {.berth = kBerth, .longest_sortie_s = 1800.0, .daylight = Daylight{6, 6.6}});
  ASSERT_GE(job.summary.sorties.size(), 2U);
  double day = 0.0;
  for (const JobSortie& sortie : job.summary.sorties) {
    const double hour = std::fmod(sortie.begins_s, 86400.0) / 3600.0;
    EXPECT_GE(hour, 6.0);
    EXPECT_LE(hour + sortie.with_contingency_s / 3600.0, 6.6 + 1e-9);
    EXPECT_GE(std::floor(sortie.begins_s / 86400.0), day);
    day = std::floor(sortie.begins_s / 86400.0);
  }
}

TEST(WholeJob, TwoBoatsTakeLittleMoreThanHalfTheTimeAndKeepApart) {
  const JobSite bench;
  const Route main = bench.rows(20);
  const Job job = made(bench, main, {.berth = kBerth, .boats = 2});
  ASSERT_EQ(job.summary.boats, 2);
  EXPECT_LT(job.summary.makespan_s, 0.58 * job.summary.undivided_s);
  EXPECT_EQ(job.summary.apart.within_a_swath_s, 0.0);
  EXPECT_EQ(job.summary.apart.neighbours_s, 0.0);
  EXPECT_EQ(main_lines(job.route), main_lines(main));
  // The watch over the routes says the same.
  std::vector<BoatTrack> tracks;
  for (std::size_t k = 0; k < 2; ++k) {
    tracks.push_back({{job.summary.sorties[k].begins_s, &job.routes[k]}});
  }
  EXPECT_EQ(boats_apart(tracks, bench.site.ground, bench.how.vehicle).neighbours_s, 0.0);
}

std::vector<int> patch_lines(const Route& route) {
  std::vector<int> numbers;
  for (const Waypoint& w : route.waypoints) {
    if (w.kind != LegKind::patch || !w.line) continue;
    if (numbers.empty() || numbers.back() != *w.line) numbers.push_back(*w.line);
  }
  return numbers;
}

TEST(WholeJob, EachBoatSailsThePatchTestAtAnotherTime) {
  const JobSite bench;
  const Job one = made(bench, bench.rows(12), {.berth = kBerth, .patch_test = true});
  const std::vector<int> numbers = patch_lines(one.route);
  ASSERT_FALSE(numbers.empty());
  const Job two = made(bench, bench.rows(12), {.berth = kBerth, .patch_test = true, .boats = 2});
  ASSERT_EQ(two.routes.size(), 2U);
  for (const Route& route : two.routes) EXPECT_EQ(patch_lines(route), numbers);
  const auto first_kind = [](const Route& route) {
    return std::find_if(route.waypoints.begin(), route.waypoints.end(),
                        [](const Waypoint& w) { return is_survey(w.kind); })
        ->kind;
  };
  EXPECT_EQ(first_kind(two.routes[0]), LegKind::patch);
  EXPECT_NE(first_kind(two.routes[1]), LegKind::patch);
  const double longest = two.summary.makespan_s;
  for (const JobSortie& sortie : two.summary.sorties) {
    EXPECT_GT(sortie.duration_s, 0.85 * longest) << "both have the test to sail";
  }
  // Taken up again for one boat, it is sailed once.
  EXPECT_EQ(patch_lines(made(bench, two.route, {.berth = kBerth}).route), numbers);
}

TEST(WholeJob, WithoutABerthSortiesBeginWhereTheFirstLineDoes) {
  const JobSite bench;
  const Route main = bench.rows(20);
  const Job job = made(bench, main, {.longest_sortie_s = 1500.0});
  EXPECT_EQ(job.route.waypoints.front().position, main.waypoints.front().position);
  EXPECT_THAT(job.notes, testing::Contains(testing::HasSubstr("no berth was given")));
}

TEST(WholeJob, ABerthInOtherWaterIsCutOff) {
  JobSite bench;
  bench.site.ground.water =
      subtract(bench.site.ground.water, Area{{{{0, 40}, {600, 40}, {600, 60}, {0, 60}}, {}}});
  const JobSite open;
  const std::string message = message_of<UsageError>(
      [&] { static_cast<void>(made(bench, open.rows(3), {.berth = kBerth})); });
  EXPECT_THAT(message,
              testing::AllOf(testing::HasSubstr("300.0,20.0"), testing::HasSubstr("cut off")));
}

// A channel of 4 m with a right angle leads to the berth, and the vehicle turns in 12 m.
TEST(WholeJob, AWayToABerthThatCannotBeSteeredIsSaidWithItsPlace) {
  JobSite bench;
  const Route main = bench.rows(3);
  const Area open{{{{40, 60}, {560, 60}, {560, 390}, {40, 390}}, {}}};
  const Area channel{{{{40, 20}, {90, 20}, {90, 24}, {44, 24}, {44, 61}, {40, 61}}, {}}};
  bench.site.ground.water = unite(open, channel);
  bench.how.vehicle.turn_radius_m = 12.0;
  const Job job = made(bench, main, {.berth = Vec2(85, 22)});
  ASSERT_FALSE(job.route.waypoints.front().feasible && job.route.waypoints[1].feasible);
  const auto said = [](const char* way) {
    return testing::Contains(testing::AllOf(testing::HasSubstr(way),
                                            testing::HasSubstr("the berth at 85.0,22.0"),
                                            testing::HasSubstr("turns of 12 m")));
  };
  EXPECT_THAT(job.notes, said("a way out of"));
  EXPECT_THAT(job.notes, said("a way home to"));
  // Of a berth in the open nothing is to say.
  for (const std::string& note : made(bench, main, {.berth = Vec2(300, 300)}).notes) {
    EXPECT_THAT(note, testing::Not(testing::HasSubstr("cannot be sailed as drawn")));
  }
}

TEST(WholeJob, RefusesOptionsOutOfTheirRange) {
  EXPECT_THROW(check(JobOptions{.boats = 0}), UsageError);
  EXPECT_THROW(check(JobOptions{.boats = 9}), UsageError);
  EXPECT_THROW(check(JobOptions{.cross_share = 2.0}), UsageError);
  EXPECT_THROW(check(JobOptions{.longest_sortie_s = 0.0}), UsageError);
  EXPECT_NO_THROW(check(JobOptions{}));
}

TEST(WholeJob, TheSameJobTwiceIsTheSame) {
  const JobSite bench;
  const JobOptions how{
      .berth = kBerth, .cross_share = 0.05, .longest_sortie_s = 1500.0, .boats = 2};
  const Job one = made(bench, bench.rows(12), how);
  const Job two = made(bench, bench.rows(12), how);
  ASSERT_EQ(one.route.waypoints.size(), two.route.waypoints.size());
  for (std::size_t i = 0; i < one.route.waypoints.size(); ++i) {
    EXPECT_EQ(one.route.waypoints[i].position, two.route.waypoints[i].position);
  }
}

}  // namespace
}  // namespace swathplan

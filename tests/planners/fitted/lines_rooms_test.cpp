#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/fitted/line_workshop.h"
#include "planners/fronts/eikonal.h"
#include "planners/fronts/field_lines.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/fronts/level_lines.h"
#include "planners/fronts/line_angles.h"
#include "planners/pareto.h"
#include "planners/rows/line_order.h"

namespace swathplan {
namespace {

struct Ground {
  explicit Ground(Seafloor floor) : seafloor(std::move(floor)), depths(seafloor) {
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.survey_area = ground.water = survey_area(seafloor, {});
  }
  Seafloor seafloor;
  DepthQuery depths;
  PlanningGround ground;
};

TEST(ParetoFront, KeepsWhatNothingBeats) {
  std::vector<Outcome> outcomes(5);
  const double ratio[] = {2.0, 1.5, 1.5, 3.0, 2.5};
  const double hit[] = {98.0, 96.0, 95.0, 97.0, 99.0};
  for (std::size_t i = 0; i < 5; ++i) {
    outcomes[i].length_ratio = ratio[i];
    outcomes[i].cover_pct = hit[i];
  }
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 0, 4}));
  EXPECT_TRUE(pareto_front({}).empty());
  // One that is longer or covers less, but can be steered, stays.
  outcomes[0].infeasible_legs = 1;
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 0, 4}));
  outcomes[0].infeasible_legs = 0;
  outcomes[1].infeasible_legs = 2;
  EXPECT_EQ(pareto_front(outcomes), (std::vector<std::size_t>{1, 2, 0, 4}));
}

TEST(ParetoPick, PrefersWhatCanBeSteered) {
  std::vector<Outcome> outcomes(2);
  outcomes[0].length_ratio = 2.48, outcomes[0].cover_pct = 98.2;
  outcomes[1].length_ratio = 2.50, outcomes[1].cover_pct = 99.3;
  EXPECT_EQ(pick(outcomes, {}).index, 1U);
  EXPECT_EQ(pick(outcomes, {}).why.find("infeasible"), std::string::npos);
  outcomes[1].infeasible_legs = 1;
  EXPECT_EQ(pick(outcomes, {}).index, 0U);
  EXPECT_NE(pick(outcomes, {}).why.find("infeasible"), std::string::npos);
  PlanGoal within;
  within.length_m = 1.0;
  EXPECT_EQ(pick(outcomes, within).index, 0U);
}

TEST(ParetoPick, FollowsTheGoalAndSaysWhenItIsOutOfReach) {
  std::vector<Outcome> outcomes(3);
  for (std::size_t i = 0; i < 3; ++i) {
    outcomes[i].length_ratio = 1.0 + static_cast<double>(i);
    outcomes[i].length_m = 100.0 * outcomes[i].length_ratio;
    outcomes[i].duration_s = 50.0 * outcomes[i].length_ratio;
  }
  outcomes[0].cover_pct = 90.0;
  outcomes[1].cover_pct = 98.0;
  outcomes[2].cover_pct = 99.0;
  EXPECT_EQ(pick(outcomes, {}).index, 1U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = 98.5, .length_m = {}, .time_s = {}}).index, 2U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = {}, .length_m = 250.0, .time_s = {}}).index, 1U);
  EXPECT_EQ(pick(outcomes, {.coverage_pct = {}, .length_m = {}, .time_s = 60.0}).index, 0U);
  const Pick most = pick(outcomes, {.coverage_pct = 99.9, .length_m = {}, .time_s = {}});
  EXPECT_EQ(most.index, 2U);
  EXPECT_NE(most.why.find("no plan that was tried reaches"), std::string::npos);
}

TEST(ParetoPick, TakesMorePathWhereTheFanIsTooNarrow) {
  EXPECT_EQ(worth_per_ratio(1.2), kWorthPerRatio);
  EXPECT_EQ(worth_per_ratio(kUsualRatio), kWorthPerRatio);
  EXPECT_EQ(worth_per_ratio(2.0 * kUsualRatio), 0.5 * kWorthPerRatio);
  std::vector<Outcome> outcomes(2);
  outcomes[0].length_ratio = 3.0, outcomes[0].cover_pct = 91.7;
  outcomes[1].length_ratio = 5.0, outcomes[1].cover_pct = 97.5;
  EXPECT_EQ(pick(outcomes, {}).index, 0U);
  EXPECT_EQ(pick(outcomes, {}, worth_per_ratio(4.0)).index, 1U);
}

TEST(ParetoPick, ListsWhatLiesAboutTheGoal) {
  std::vector<Outcome> outcomes(4);
  for (std::size_t i = 0; i < 4; ++i) {
    outcomes[i].length_ratio = 1.0 + static_cast<double>(i);
    outcomes[i].cover_pct = 90.0 + 3.0 * static_cast<double>(i);
  }
  using List = std::vector<std::size_t>;
  const List front = pareto_front(outcomes);
  PlanGoal goal;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), List{});
  goal.coverage_pct = 95.0;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{2, 3, 1}));
  goal.coverage_pct = 50.0;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{0, 1}));
  goal.coverage_pct = 99.5;
  EXPECT_EQ(about_the_goal(outcomes, front, goal), (List{3, 2}));
  EXPECT_EQ(about_the_goal({}, {}, goal), List{});
}

TEST(Eikonal, CountsWidthsFromAPointOnEvenGround) {
  const Ground g(flat(60.0, 60.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  const std::vector<float> width(raster.size(), 5.0F);
  const auto from = raster.cell_at({30.0, 30.0});
  ASSERT_TRUE(from.has_value());
  const Front front = march(raster, width, {{*from, 0.0, 7}});
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) {
      EXPECT_TRUE(std::isinf(front.u[i]));
      continue;
    }
    const double exact = (raster.centre(i) - raster.centre(*from)).norm() / 5.0;
    // First order: too long by the diagonal's error near the point, under 0.2 widths here.
    EXPECT_NEAR(static_cast<double>(front.u[i]), exact, 0.2);
    EXPECT_EQ(front.label[i], 7U);
  }
}

TEST(LevelLines, OfAPlaneAreStraightAndWhole) {
  const Ground g(flat(40.0, 30.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  std::vector<float> u(raster.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = raster.in_area(i) ? static_cast<float>(raster.centre(i).x())
                             : std::numeric_limits<float>::infinity();
  }
  const auto lines = level_lines(raster, u, 17.2);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length_m(lines[0]), 30.0, 1.01);
  for (const Vec2& p : lines[0].points) EXPECT_NEAR(p.x(), 17.2, 1e-4);
}

TEST(FieldLines, SpacingFollowsTheWidthAndLengthItsIntegral) {
  const Ground g(tilted(200.0, 120.0, 8.0, Angle::degrees(5.0)));
  const WaterRaster raster(g.ground, 1e6, 0.5);
  PlanOptions options;
  options.resolution_m = 0.25;
  const std::vector<float> width = width_field(raster, options, 1.0);
  const FieldWall west{{0.0, 0.0}, {0.0, 120.0}};
  const AreaQuery area(g.ground.survey_area);
  double metres = 0.0;
  double before = 0.0;
  for (const SurveyCurve& line : field_lines(raster, width, area, west, 0.1)) {
    metres += length_m(line);
    const double x = line.points[line.points.size() / 2].x();
    EXPECT_GT(x, before);
    before = x;
  }
  // One line more or less.
  EXPECT_NEAR(metres, least_line_m(raster, width), 120.0);
}

TEST(FittedStraight, RowsStandCloserOverShoalGround) {
  const Ground g(tilted(200.0, 120.0, 8.0, Angle::degrees(5.0)));
  const WaterRaster raster(g.ground);
  PlanOptions options;
  options.resolution_m = 0.25;
  const AreaQuery area(g.ground.survey_area);
  const auto lines = fitted_straight_lines(raster, width_field(raster, options, 1.0), area, area,
                                           {.azimuth = Angle::degrees(0.0), .lines = 6});
  ASSERT_EQ(lines.size(), 6U);
  double spacing = 0.0;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const double here = lines[k + 1].points[0].x() - lines[k].points[0].x();
    EXPECT_GT(here, spacing);
    spacing = here;
    EXPECT_NEAR(length_m(lines[k]), 119.9, 0.01);
  }
}

TEST(LineAngles, SidesMeetTheNeighbourAndStopAtTheEdge) {
  const Ground g(flat(60.0, 40.0, 10.0));
  const WaterRaster raster(g.ground, 1e6, 0.25);
  PlanOptions options;
  options.resolution_m = 0.25;
  options.vehicle.draft_m = 0.0;
  const std::vector<float> width(raster.size(), 100.0F);
  const AreaQuery area(g.ground.survey_area);
  // Northward at x = 10 and 30: port of the first sees 10 m to the edge, starboard 10 m half-way.
  const auto lines = opened_lines(
      {straight_curve({10.0, 0.5}, {10.0, 39.5}), straight_curve({30.0, 0.5}, {30.0, 39.5})},
      raster, width, area, options, {.overlap_m = 0.5, .widest_share = 1.0, .by_distance = false});
  ASSERT_EQ(lines.size(), 2U);
  const FanAngles fan = *lines[0][20].fan;
  EXPECT_NEAR(10.0 * tan(fan.port), 10.0, 0.05);
  EXPECT_NEAR(10.0 * tan(fan.starboard), 10.5, 0.3);
  EXPECT_NEAR(10.0 * tan(lines[1][20].fan->starboard), 30.0, 0.05);
}

TEST(LineAngles, AShadowIsTheOtherLinesToSee) {
  // A wall at x = 30 down to the deep east: from the shoal side its foot is hidden.
  const Ground g(stepped(60.0, 40.0, 5.0, 30.0));
  const WaterRaster raster(g.ground, 1e6, 0.25);
  PlanOptions options;
  options.resolution_m = 0.25;
  const std::vector<float> width(raster.size(), 60.0F);
  const AreaQuery area(g.ground.survey_area);
  const auto lines = opened_lines(
      {straight_curve({24.0, 0.5}, {24.0, 39.5}), straight_curve({50.0, 0.5}, {50.0, 39.5})},
      raster, width, area, options, {.overlap_m = 0.5, .widest_share = 1.0, .by_distance = false});
  // Half-way is x = 37, but the first line sees no ground between x = 30 and about 60.
  const double reach = 29.7 * tan(lines[1][20].fan->port);
  EXPECT_GE(reach, 19.5);
}

TEST(Workshop, ALineSailedBackwardsKeepsItsFansOnTheirGround) {
  std::vector<Waypoint> line(3);
  for (std::size_t i = 0; i < 3; ++i) line[i].position = {0.0, static_cast<double>(i)};
  line[0].fan = FanAngles{Angle::degrees(10.0), Angle::degrees(20.0)};
  line[1].fan = line[2].fan = FanAngles{Angle::degrees(30.0), Angle::degrees(40.0)};
  const auto back = backwards(line);
  EXPECT_EQ(back[0].position, line[2].position);
  EXPECT_EQ(*back[0].fan, (FanAngles{Angle::degrees(40.0), Angle::degrees(30.0)}));
  EXPECT_EQ(*back[1].fan, (FanAngles{Angle::degrees(20.0), Angle::degrees(10.0)}));
}

double tour_length(const std::vector<LineEnds>& lines, const std::vector<OrderedLine>& order,
                   const JoinCost& cost) {
  const auto begin = [&](const OrderedLine& l) {
    const LineEnds& e = lines[l.line];
    return l.backwards ? std::pair<Vec2, Vec2>(e.to, -e.course_to)
                       : std::pair<Vec2, Vec2>(e.from, e.course_from);
  };
  const auto end = [&](const OrderedLine& l) {
    const auto [at, course] = begin({l.line, !l.backwards});
    return std::pair<Vec2, Vec2>(at, -course);
  };
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto [a, ca] = end(order[k]);
    const auto [b, cb] = begin(order[k + 1]);
    sum += cost(a, ca, b, cb);
  }
  return sum;
}

TEST(LineOrder, IsNearTheBestOfAllOrdersOfFiveLines) {
  const Area water{{{{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}}, {}}};
  const JoinCost cost(water, 2.0);
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int round = 0; round < 10; ++round) {
    std::vector<LineEnds> lines(5);
    for (LineEnds& l : lines) {
      l.from = {100.0 * uniform(), 100.0 * uniform()};
      l.to = {100.0 * uniform(), 100.0 * uniform()};
      l.course_from = l.course_to = (l.to - l.from).normalized();
    }
    const auto found = line_order(lines, cost, std::nullopt);
    ASSERT_EQ(found.size(), 5U);
    std::vector<std::size_t> permutation{0, 1, 2, 3, 4};
    double best = 1e300;
    do {
      for (unsigned turned = 0; turned < 32; ++turned) {
        std::vector<OrderedLine> order;
        for (std::size_t k = 0; k < 5; ++k)
          order.push_back({permutation[k], ((turned >> k) & 1U) != 0});
        best = std::min(best, tour_length(lines, order, cost));
      }
    } while (std::next_permutation(permutation.begin(), permutation.end()));
    EXPECT_LE(tour_length(lines, found, cost), 1.15 * best);
    EXPECT_GE(tour_length(lines, found, cost), best - 1e-6);
  }
}

TEST(JoinCost, GoesRoundWhatLiesBetween) {
  // A wall from the south up to y = 80.
  const Area water{{{{0.0, 0.0},
                     {49.0, 0.0},
                     {49.0, 80.0},
                     {51.0, 80.0},
                     {51.0, 0.0},
                     {100.0, 0.0},
                     {100.0, 100.0},
                     {0.0, 100.0}},
                    {}}};
  const JoinCost cost(water, 2.0);
  EXPECT_DOUBLE_EQ(cost.way({10.0, 10.0}, {40.0, 10.0}), 30.0);
  const double round = 2.0 * std::hypot(9.0, 70.0) + 2.0;
  EXPECT_NEAR(cost.way({40.0, 10.0}, {60.0, 10.0}), round, 0.1 * round);
}

}  // namespace
}  // namespace swathplan

#include "planners/rows/row_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/shapes.h"

namespace swathplan {
namespace {

using test::box_area;

std::vector<SurveyLine> five_rows() {
  std::vector<SurveyLine> lines;
  for (int k = 0; k < 5; ++k) lines.push_back({{100.0, 10.0 * k}, {200.0, 10.0 * k}, k});
  return lines;
}

/// Waypoints 100 m apart in a row; `feasible` tells whether the join in the middle was found.
BuiltRoute two_lines(double join_m, bool feasible) {
  Route route;
  double x = 0.0;
  const auto add = [&](LegKind kind, bool log, bool steered, double ahead_m) {
    Waypoint w;
    w.position = {x, 0.0};
    w.kind = kind;
    w.log = log;
    w.feasible = steered;
    route.waypoints.push_back(w);
    x += ahead_m;
  };
  add(LegKind::line, true, true, 100.0);
  add(LegKind::turn, false, feasible, join_m);
  add(LegKind::line, true, true, 100.0);
  add(LegKind::end, false, true, 0.0);
  return {std::move(route), {}};
}

TEST(RowOrder, RowsNeedSkipsOnceATurnIsWiderThanTheyAreApart) {
  PlanOptions options;
  options.vehicle.turn_radius_m = 0.5 * footprint_width_m(options);
  EXPECT_FALSE(rows_need_skips(options));
  options.vehicle.turn_radius_m += 0.01;
  EXPECT_TRUE(rows_need_skips(options));
}

TEST(RowOrder, LeastWayHoldsEveryRowOnceAndAvoidsAJoinThatWasNotFound) {
  const JoinCost cost(box_area(0, -100, 300, 140), 10.0);
  const auto lines = five_rows();
  RowOrder order{false, {}};
  const auto first = ordered(lines, order, cost, 10.0, std::nullopt);
  ASSERT_EQ(first.size(), 5U);
  std::vector<int> rows;
  for (const SurveyLine& line : first) rows.push_back(line.row);
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(rows, (std::vector<int>{0, 1, 2, 3, 4}));

  const Vec2 end = first[0].to, begin = first[1].from;
  order.avoided.emplace_back(end, begin);
  const auto second = ordered(lines, order, cost, 10.0, std::nullopt);
  for (std::size_t i = 1; i < second.size(); ++i) {
    const auto is = [&](const Vec2& a, const Vec2& b) {
      return (second[i - 1].to - a).norm() < 1e-6 && (second[i].from - b).norm() < 1e-6;
    };
    EXPECT_FALSE(is(end, begin) || is(begin, end));
  }
}

TEST(RowOrder, ShorterOrderBuildsOnceWhereRowsNeedNoSkips) {
  PlanOptions options;
  int built = 0;
  const auto best = shorter_order(options, [&](const RowOrder& order) {
    ++built;
    EXPECT_TRUE(order.to_and_fro);
    return two_lines(50.0, true);
  });
  EXPECT_EQ(built, 1);
  EXPECT_TRUE(best.notes.empty());
}

TEST(RowOrder, ShorterOrderTakesTheShortestRouteThatCanBeSteered) {
  PlanOptions options;
  options.vehicle.turn_radius_m = footprint_width_m(options);
  int built = 0;
  const auto best = shorter_order(options, [&](const RowOrder& order) {
    ++built;
    if (order.to_and_fro) return two_lines(90.0, true);
    // The first order of least way is shorter, but its join was not found.
    if (order.avoided.empty()) return two_lines(20.0, false);
    EXPECT_EQ(order.avoided.size(), 1U);
    return two_lines(60.0, true);
  });
  EXPECT_EQ(built, 3);
  EXPECT_DOUBLE_EQ(length_m(best.route), 260.0);
  ASSERT_EQ(best.notes.size(), 1U);
}

}  // namespace
}  // namespace swathplan

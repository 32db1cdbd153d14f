#include "planners/rows/line_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace swathplan {
namespace {

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

}  // namespace
}  // namespace swathplan

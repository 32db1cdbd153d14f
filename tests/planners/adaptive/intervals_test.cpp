#include "planners/adaptive/intervals.h"

#include <gtest/gtest.h>

#include "mesh/base/random.h"

namespace swathplan {
namespace {

TEST(Intervals, TouchingStretchesBecomeOne) {
  IntervalSet set;
  set.add({0.0, 1.0});
  set.add({2.0, 3.0});
  EXPECT_FALSE(set.covers({0.5, 2.5}));
  set.add({1.0, 2.0});
  ASSERT_EQ(set.stretches().size(), 1U);
  EXPECT_EQ(set.stretches()[0], (Interval{0.0, 3.0}));
  EXPECT_DOUBLE_EQ(set.run_end(0.5), 3.0);
  EXPECT_DOUBLE_EQ(set.run_end(4.0), 4.0);
}

TEST(Intervals, EmptyAndReversedChangeNothing) {
  IntervalSet set;
  set.add({1.0, 1.0});
  set.add({2.0, 1.0});
  EXPECT_TRUE(set.stretches().empty());
  EXPECT_FALSE(set.covers({1.0, 1.0}));
}

// Oracle: a row of a thousand cells.
TEST(Intervals, AgreesWithARowOfCells) {
  SeededNumbers numbers(3);
  for (int round = 0; round < 200; ++round) {
    IntervalSet set;
    std::vector<bool> cells(100, false);
    for (int k = 0; k < 12; ++k) {
      const auto a = numbers.below(100);
      const auto b = a + numbers.below(100 - a + 1);
      set.add({static_cast<double>(a), static_cast<double>(b)});
      for (auto i = a; i < b; ++i) cells[i] = true;
    }
    const auto from = numbers.below(90);
    const auto to = from + 1 + numbers.below(10);
    int covered = 0;
    for (auto i = from; i < to; ++i) covered += cells[i] ? 1 : 0;
    const Interval stretch{static_cast<double>(from), static_cast<double>(to)};
    EXPECT_DOUBLE_EQ(set.covered_m(stretch), covered);
    EXPECT_EQ(set.covers(stretch), covered == static_cast<int>(to - from));
  }
}

}  // namespace
}  // namespace swathplan

#include "coverage/standards/criteria.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct OrderRow {
  const char* name;
  double tvu_at_20, tvu_at_200, thu_at_20, thu_at_200;
  double feature_at_20, feature_at_200;  // 0: none
  int lines;
  double share_pct;
};

TEST(Criteria, HoldTheLimitsOfEveryOrder) {
  const std::vector<OrderRow> rows{
      {"s44-exclusive", std::hypot(0.15, 0.15), std::hypot(0.15, 1.5), 1, 1, 0.5, 0.5, 2, 100},
      {"s44-special", std::hypot(0.25, 0.15), std::hypot(0.25, 1.5), 2, 2, 1, 1, 1, 100},
      {"s44-1a", std::hypot(0.5, 0.26), std::hypot(0.5, 2.6), 6, 15, 2, 20, 1, 100},
      {"s44-1b", std::hypot(0.5, 0.26), std::hypot(0.5, 2.6), 6, 15, 0, 0, 1, 5},
      {"s44-2", std::hypot(1.0, 0.46), std::hypot(1.0, 4.6), 22, 40, 0, 0, 1, 5},
      {"noaa-object-detection", std::hypot(0.5, 0.26), std::hypot(1.0, 4.6), 6, 15, 0, 0, 1, 100},
      {"noaa-complete-coverage", std::hypot(0.5, 0.26), std::hypot(1.0, 4.6), 6, 15, 0, 0, 1, 100}};
  ASSERT_EQ(criteria().size(), rows.size());
  for (const OrderRow& row : rows) {
    const Criterion& order = criterion(row.name);
    EXPECT_NEAR(tvu_limit_m(order, 20), row.tvu_at_20, 1e-12) << row.name;
    EXPECT_NEAR(tvu_limit_m(order, 200), row.tvu_at_200, 1e-12) << row.name;
    EXPECT_NEAR(thu_limit_m(order, 20), row.thu_at_20, 1e-12) << row.name;
    EXPECT_NEAR(thu_limit_m(order, 200), row.thu_at_200, 1e-12) << row.name;
    EXPECT_NEAR(feature_m(order, 20).value_or(0), row.feature_at_20, 1e-12) << row.name;
    EXPECT_NEAR(feature_m(order, 200).value_or(0), row.feature_at_200, 1e-12) << row.name;
    EXPECT_EQ(lines_asked(order), row.lines) << row.name;
    EXPECT_EQ(share_asked_pct(order), row.share_pct) << row.name;
  }
}

TEST(Criteria, HaveCellsByDepth) {
  const auto cells = [](const char* name) {
    std::vector<double> sides;
    for (const double depth : {20.0, 40.0, 80.0, 160.0, 320.0}) {
      sides.push_back(cell_m(criterion(name), depth));
    }
    return sides;
  };
  EXPECT_THAT(cells("noaa-object-detection"), ::testing::ElementsAre(0.5, 1, 4, 8, 16));
  EXPECT_THAT(cells("noaa-complete-coverage"), ::testing::ElementsAre(1, 2, 4, 8, 16));
  EXPECT_THAT(cells("s44-special"), ::testing::Each(0.5));
  EXPECT_THAT(cells("s44-exclusive"), ::testing::Each(0.25));
}

TEST(Criteria, HaveCellsOfAtMostHalfAFeature) {
  for (const Criterion& order : criteria()) {
    for (double depth = 1.0; depth < 1000.0; depth += 1.0) {
      const auto feature = feature_m(order, depth);
      if (feature) {
        EXPECT_LE(cell_m(order, depth), 0.5 * *feature + 1e-12) << order.name << depth;
      }
    }
  }
}

TEST(Criteria, RefuseOtherNamesWithTheirOwn) {
  try {
    (void)criterion("s44-1");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("s44-exclusive, s44-special, s44-1a"));
  }
}

}  // namespace
}  // namespace swathplan

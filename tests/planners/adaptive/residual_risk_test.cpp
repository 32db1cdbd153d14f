#include "planners/adaptive/residual_risk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {
namespace {

const DetectionCurve kFlat{{10, 50}, {0.3, 0.3}};

TEST(ResidualRisk, LooksMultiply) {
  const std::vector<SurveyTrack> tracks{{0, 0, true}, {1, 50, false}};
  const auto map = residual_risk(tracks, kFlat, {.width_m = 100, .length_m = 10, .cell_m = 5});
  ASSERT_EQ(map.columns, 20);
  ASSERT_EQ(map.rows, 2);
  const auto at = [&](double x) { return map.risk[static_cast<std::size_t>(x / 5)]; };
  EXPECT_DOUBLE_EQ(at(2), 0.7);         // nadir of the first, the second's far end
  EXPECT_DOUBLE_EQ(at(27), 0.7 * 0.7);  // both
  EXPECT_DOUBLE_EQ(at(57), 1.0);        // nadir of the second, beyond the first
  EXPECT_DOUBLE_EQ(at(97), 0.7);
  EXPECT_DOUBLE_EQ(uncovered_share(map), 2.0 / 20.0);
  EXPECT_EQ(looked_at(map).size(), 36U);
}

TEST(ResidualRisk, BorderIsLeftOut) {
  ResidualRiskMap map{4, 3, 5.0, std::vector<double>(12)};
  std::iota(map.risk.begin(), map.risk.end(), 0.0);
  const auto inner = without_border(map, 5.0);
  EXPECT_EQ(inner.risk, (std::vector<double>{5, 6}));
  EXPECT_TRUE(without_border(map, 50.0).risk.empty());
}

TEST(ResidualRisk, HistogramCountsAll) {
  const std::vector<double> values{0.0, 0.09, 0.1, 0.95, 1.0};
  const auto counts = histogram(values, 10);
  EXPECT_EQ(counts[0], 2);
  EXPECT_EQ(counts[1], 1);
  EXPECT_EQ(counts[9], 2);
}

TEST(ResidualRisk, MixtureFindsItsComponents) {
  SeededNumbers numbers(11);
  std::vector<double> values;
  for (int i = 0; i < 7000; ++i) values.push_back(0.55 + 0.03 * numbers.normal());
  for (int i = 0; i < 3000; ++i) values.push_back(0.80 + 0.04 * numbers.normal());
  const auto fit = fitted_mixture(values, 2);
  ASSERT_EQ(fit.size(), 2U);
  EXPECT_NEAR(fit[0].mean, 0.55, 0.005);
  EXPECT_NEAR(fit[1].mean, 0.80, 0.005);
  EXPECT_NEAR(fit[1].sigma, 0.04, 0.005);
  EXPECT_NEAR(fit[1].share, 0.3, 0.01);
  EXPECT_DOUBLE_EQ(fitted_mixture(values, 2)[1].mean, fit[1].mean);
}

std::vector<double> three_heaps() {
  SeededNumbers numbers(12);
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(0.5 + 0.05 * numbers.normal());
  for (int i = 0; i < 1000; ++i) values.push_back(0.7 + 0.05 * numbers.normal());
  for (int i = 0; i < 500; ++i) values.push_back(0.9 + 0.03 * numbers.normal());
  return values;
}

// OpenCV draws from a generator of the thread; what was drawn before must not matter.
TEST(ResidualRisk, MixtureDoesNotDependOnWhatTheThreadDrewBefore) {
  const auto values = three_heaps();
  const auto first = fitted_mixture(values, 2);
  for (int i = 0; i < 20; ++i) {
    (void)cv::theRNG().next();
    const auto state = cv::theRNG().state;
    const auto again = fitted_mixture(values, 2);
    EXPECT_EQ(cv::theRNG().state, state);
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
      EXPECT_EQ(again[k].mean, first[k].mean);
      EXPECT_EQ(again[k].sigma, first[k].sigma);
      EXPECT_EQ(again[k].share, first[k].share);
    }
  }
}

TEST(ResidualRisk, WorstComponentTellsTheSpreadOverStarts) {
  const auto values = three_heaps();
  const WorstComponent worst = worst_component(values, 2, 5);
  EXPECT_LE(worst.lowest, worst.median);
  EXPECT_LE(worst.median, worst.highest);
  const double one = fitted_mixture(values, 2, 3).back().mean;
  EXPECT_GE(one, worst.lowest);
  EXPECT_LE(one, worst.highest);
}

TEST(ResidualRisk, RefusesBadInput) {
  EXPECT_THROW((void)fitted_mixture(std::vector<double>(19, 0.5), 2), InvalidInput);
  EXPECT_THROW((void)residual_risk({}, kFlat, {.width_m = 3, .length_m = 10}), UsageError);
  EXPECT_THROW((void)residual_risk({}, kFlat, {.width_m = 30, .length_m = 10, .cell_m = 0}),
               UsageError);
  EXPECT_THROW((void)residual_risk({}, {}, {.width_m = 30, .length_m = 10}), InvalidInput);
}

}  // namespace
}  // namespace swathplan

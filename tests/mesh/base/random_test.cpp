#include "mesh/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace swathplan {
namespace {

constexpr std::uint64_t kAllOnes = std::numeric_limits<std::uint64_t>::max();

// Results of studies are published with their seeds: the sequences must never change.
TEST(Random, SequencesStayAsTheyAre) {
  SeededNumbers numbers(1);
  EXPECT_EQ(numbers.next(), 10451216379200822465U);
  EXPECT_EQ(numbers.next(), 13757245211066428519U);
  EXPECT_EQ(numbers.next(), 17911839290282890590U);
  EXPECT_EQ(numbers.uniform(), 0x1.c7061a43b90b2p-2);
  EXPECT_EQ(numbers.uniform(), 0x1.c6ed53634406cp-2);
  EXPECT_EQ(numbers.below(1000), 762U);
  EXPECT_EQ(numbers.below(1000), 877U);
  EXPECT_EQ(numbers.below(1000), 523U);
  EXPECT_DOUBLE_EQ(numbers.normal(), 0x1.ca56e94386dd9p-3);
  EXPECT_DOUBLE_EQ(numbers.normal(), -0x1.9ad5854bf4fecp-1);
  EXPECT_EQ(mixed_seed(1, 2, 3), 15432287184251514724U);
  EXPECT_EQ(mixed_seed(5, 7), 15735740426944678024U);
  EXPECT_EQ(mixed_seed(0, 0), 2558736989570252433U);
}

// As the track noise draws them.
TEST(Random, PairsOfTheMersenneTwisterStayAsTheyAre) {
  std::mt19937_64 random(1);
  const double u = uniform_above_0(random());
  const auto [a, b] = normal_pair(u, uniform_above_0(random()));
  EXPECT_DOUBLE_EQ(a, 0x1.501709ad7f201p+0);
  EXPECT_DOUBLE_EQ(b, 0x1.841511f1310afp+0);
}

TEST(Random, EndsOfTheRanges) {
  EXPECT_EQ(uniform(0), 0.0);
  EXPECT_LT(uniform(kAllOnes), 1.0);
  EXPECT_GT(uniform_above_0(0), 0.0);
  EXPECT_LE(uniform_above_0(kAllOnes), 1.0);
  EXPECT_EQ(SeededNumbers(4).below(0), 0U);
  EXPECT_EQ(normal(1.0, 0.25), 0.0);
  EXPECT_TRUE(std::isinf(normal(0.0, 0.0)));
  EXPECT_EQ(scrambled(0), 0U);
}

TEST(Random, NormalNumbersHaveMean0AndVariance1) {
  SeededNumbers numbers(7);
  constexpr int kCount = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double x = numbers.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(squares / kCount, 1.0, 0.02);
}

TEST(Random, EachCellHasASeedOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t a = 0; a < 30; ++a) {
    for (std::uint64_t b = 0; b < 30; ++b) seeds.insert(mixed_seed(1, a, b));
  }
  EXPECT_EQ(seeds.size(), 900U);
}

}  // namespace
}  // namespace swathplan

#include "planners/adaptive/quality_baselines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesh/base/error.h"
#include "mesh/base/random.h"

namespace swathplan {
namespace {

// Ten whole pitches of 410 m: 90, 250 and 220 m of each are covered.
TEST(QualityBaselines, PreplannedCoversWhatThePairedLayoutGives) {
  QualitySurveyOptions o;
  o.width_m = 4100.0;
  EXPECT_NEAR(covered_share(sail_preplanned(o, true_quality(o, 150, 150))), 1.0, 1e-12);
  EXPECT_NEAR(covered_share(sail_preplanned(o, true_quality(o, 70, 70))), 90.0 / 410.0, 1e-12);
  EXPECT_NEAR(covered_share(sail_preplanned(o, true_quality(o, 150, 0))), 220.0 / 410.0, 1e-12);
  // The neighbour pair's 40 m of overhang are missing at the edge.
  EXPECT_NEAR(covered_share(sail_preplanned(o, true_quality(o, 110, 110))), 250.0 / 410.0, 0.012);
}

// Oracle: all choices of up to four tracks over an area of 18 swaths.
TEST(QualityBaselines, FewestTracksAgreesWithBruteForce) {
  QualitySurveyOptions o;
  o.width_m = 180.0;
  o.range_max_m = 90.0;
  o.range_min_m = 20.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SeededNumbers numbers(seed);
    TrueQuality truth = true_quality(o, 90, 90);
    for (auto* side : {&truth.port, &truth.starboard}) {
      for (char& good : *side) good = numbers.uniform() < (seed % 2 ? 0.75 : 0.55) ? 1 : 0;
    }
    std::vector<unsigned> masks;
    for (int i = 0; i <= 18; ++i) {
      for (const bool outbound : {true, false}) {
        unsigned mask = 0;
        for (int b = 0; b < range_bins(o); ++b) {
          const auto k = static_cast<std::size_t>(b);
          const auto& low = outbound ? truth.port : truth.starboard;
          const auto& high = outbound ? truth.starboard : truth.port;
          const int below = i - 2 - b - 1;
          const int above = i + 2 + b;
          if (low[k] && below >= 0 && below < 18) mask |= 1U << static_cast<unsigned>(below);
          if (high[k] && above < 18) mask |= 1U << static_cast<unsigned>(above);
        }
        masks.push_back(mask);
      }
    }
    const unsigned all = (1U << 18U) - 1U;
    std::size_t best = 99;
    for (std::size_t a = 0; a < masks.size(); ++a) {
      for (std::size_t b = a; b < masks.size(); ++b) {
        if ((masks[a] | masks[b]) == all) best = 2;
        for (std::size_t c = b; c < masks.size(); ++c) {
          const unsigned three = masks[a] | masks[b] | masks[c];
          if (three == all) best = std::min<std::size_t>(best, 3);
          for (std::size_t d = c; d < masks.size() && best > 4; ++d) {
            if ((three | masks[d]) == all) best = 4;
          }
        }
      }
    }
    const auto tracks = fewest_tracks(o, truth);
    if (best <= 4) {
      EXPECT_EQ(tracks.size(), best) << "seed " << seed;
    } else {
      EXPECT_TRUE(tracks.empty() || tracks.size() > 4) << "seed " << seed;
    }
  }
}

TEST(QualityBaselines, ImpossibleOptimumIsEmpty) {
  const QualitySurveyOptions o;
  EXPECT_TRUE(fewest_tracks(o, true_quality(o, 0, 0)).empty());
}

TEST(QualityBaselines, TheOptimumIsNotKnownForNarrowSwaths) {
  QualitySurveyOptions o;
  EXPECT_TRUE(optimum_known(o));
  o.swath_m = 2.5;
  EXPECT_FALSE(optimum_known(o));
  EXPECT_THROW((void)fewest_tracks(o, true_quality(o, 70, 70)), UsageError);
}

TEST(QualityBaselines, TravelCountsTheWayBackToTheSameEnd) {
  EXPECT_EQ(travel_m({}, 400.0), 0.0);
  EXPECT_DOUBLE_EQ(travel_m({{0, 0.0, true}, {1, 30.0, false}}, 400.0), 830.0);
  // Both tracks run the same way: the transit crosses the box.
  EXPECT_DOUBLE_EQ(travel_m({{0, 0.0, true}, {1, 300.0, true}}, 400.0), 800.0 + 500.0);
}

}  // namespace
}  // namespace swathplan

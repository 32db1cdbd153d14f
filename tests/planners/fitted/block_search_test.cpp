#include <gtest/gtest.h>

#include <algorithm>

#include "planners/fitted/block_search_internal.h"
#include "planners/fronts/fitted_straight.h"
#include "planners/two_basins.h"

namespace swathplan {
namespace {

using test::TwoBasins;

StraightCandidate four_rows() {
  StraightCandidate c;
  c.azimuth_deg = 90.0;
  c.lines = 4;
  return c;
}

TEST(BlockSearch, FindsNothingWorseThanItsBaseAndShorterPlansForDearerMetres) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const StraightCandidate base = four_rows();
  const Outcome before =
      shop.estimate(lines_of(base, shop), width_of(base, shop), angles_of(base), 2, "base");
  BlockSearch search(base, 2, shop);
  ASSERT_TRUE(search.has_blocks());
  const auto dense = search.best_for(0.2);
  const auto brief = search.best_for(20.0);
  ASSERT_TRUE(dense && brief);
  EXPECT_GT(worth(dense->outcome, 0.2), worth(before, 0.2));
  EXPECT_GT(worth(brief->outcome, 20.0), worth(before, 20.0));
  EXPECT_LT(brief->outcome.length_ratio, dense->outcome.length_ratio);
  const auto between = search.best_between(brief->outcome, dense->outcome);
  if (between) {
    EXPECT_GT(between->outcome.length_ratio, brief->outcome.length_ratio);
    EXPECT_LT(between->outcome.length_ratio, dense->outcome.length_ratio);
  }
  EXPECT_FALSE(search.best_between(brief->outcome, brief->outcome));
  EXPECT_FALSE(search.best_for(20.0)) << "the same rows are not worth a second look";
}

TEST(BlockSearch, LaysLinesInTheWaterWhateverTheThreads) {
  TwoBasins site;
  std::vector<Outcome> outcomes;
  for (const int threads : {1, 2}) {
    site.options.threads = threads;
    LineWorkshop shop(site.ground, site.options);
    const auto found = BlockSearch(four_rows(), 2, shop).best_for(9.0);
    ASSERT_TRUE(found);
    for (const SurveyCurve& line : found->lines) {
      EXPECT_NEAR(shop.lines_in().inside_length(line.points.front(), line.points.back()),
                  length_m(line), 1e-6);
    }
    outcomes.push_back(found->outcome);
  }
  EXPECT_EQ(outcomes[0].cover_pct, outcomes[1].cover_pct);
  EXPECT_EQ(outcomes[0].length_m, outcomes[1].length_m);
}

TEST(BlockSearch, KeepsToAHeadingThatIsGiven) {
  TwoBasins site;
  site.options.heading = Angle::degrees(90.0);
  LineWorkshop shop(site.ground, site.options);
  const auto found = BlockSearch(four_rows(), 2, shop).best_for(20.0);
  ASSERT_TRUE(found);
  for (const SurveyCurve& line : found->lines) {
    EXPECT_NEAR(line.points.front().y(), line.points.back().y(), 1e-9);
  }
}

TEST(BlockSearch, HasNothingToMixOnARectangle) {
  const Seafloor seafloor = flat(60.0, 40.0, 6.0);
  const DepthQuery depths(seafloor);
  TwoBasins site;
  site.ground.seafloor = &seafloor;
  site.ground.depths = &depths;
  site.ground.survey_area = site.ground.water = survey_area(seafloor, {});
  LineWorkshop shop(site.ground, site.options);
  EXPECT_FALSE(BlockSearch(four_rows(), 2, shop).has_blocks());
}

TEST(Spread, TakesTheBestAtEachPriceInTurn) {
  std::vector<Outcome> outcomes(4);
  const double ratio[] = {1.0, 1.5, 2.0, 3.0};
  const double cover[] = {90.0, 96.0, 98.0, 99.0};
  for (std::size_t i = 0; i < 4; ++i) {
    outcomes[i].length_ratio = ratio[i];
    outcomes[i].cover_pct = cover[i];
  }
  using List = std::vector<std::size_t>;
  EXPECT_EQ(spread(outcomes, {0, 1, 2, 3}, {20.0, 0.5}, 3), (List{0, 3, 1}));
  EXPECT_EQ(spread(outcomes, {1, 2}, {3.0}, 5), (List{2, 1}));
  EXPECT_TRUE(spread(outcomes, {}, {4.0}, 5).empty());
}

TEST(LineWorkshop, EstimatesWhatTheSteeredRouteCovers) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const StraightCandidate base = four_rows();
  const Outcome estimate =
      shop.estimate(lines_of(base, shop), width_of(base, shop), angles_of(base), 1, "base");
  const Outcome steered = shop.judge(build(base, shop).route, 1, "base");
  EXPECT_NEAR(estimate.cover_pct, steered.cover_pct, 1.0);
  EXPECT_NEAR(estimate.length_ratio / steered.length_ratio, 1.0, 0.1);
}

}  // namespace
}  // namespace swathplan

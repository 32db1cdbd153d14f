#include "planners/fronts/row_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/fitted/block_search_internal.h"
#include "planners/fronts/fitted_straight.h"

namespace swathplan {
namespace {

/// Two basins, 25 m wide, north of a mole's root: a U that is open to the north.
struct TwoBasins {
  TwoBasins() : seafloor(flat(60.0, 60.0, 6.0)), depths(seafloor), scene(seafloor, Nodata::wall) {
    const Ring mole{{25.0, 30.0}, {35.0, 30.0}, {35.0, 61.0}, {25.0, 61.0}};
    ground.seafloor = &seafloor;
    ground.depths = &depths;
    ground.scene = &scene;
    ground.survey_area = ground.water =
        survey_area(seafloor, {.limit = {}, .no_go = {{mole, {}}}, .safe_depth_m = 0.0});
    options.resolution_m = 0.25;
  }
  Seafloor seafloor;
  DepthQuery depths;
  RayScene scene;
  PlanningGround ground;
  PlanOptions options;
};

const Angle kEast = Angle::degrees(90.0);

std::vector<SurveyCurve> rows(LineWorkshop& shop, Angle azimuth) {
  return fitted_straight_lines(shop.raster(), shop.width(1.0), shop.survey_area(), shop.lines_in(),
                               {.azimuth = azimuth, .lines = 6});
}

TEST(RowBlocks, BeginWhereARowParts) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const auto lines = rows(shop, kEast);
  ASSERT_EQ(lines.size(), 9U);
  const RowBlocks blocks = row_blocks(lines, kEast, shop.raster());
  ASSERT_EQ(blocks.lines.size(), 3U);
  for (const auto& block : blocks.lines) EXPECT_EQ(block.size(), 3U);
}

TEST(RowBlocks, HaveEveryCellOfTheAreaAndNoOther) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const RowBlocks blocks = row_blocks(rows(shop, kEast), kEast, shop.raster());
  std::vector<std::size_t> cells(blocks.lines.size(), 0);
  for (std::size_t i = 0; i < shop.raster().size(); ++i) {
    ASSERT_EQ(blocks.of_cell[i] != RowBlocks::kNone, shop.raster().in_area(i));
    if (blocks.of_cell[i] >= 0) ++cells[static_cast<std::size_t>(blocks.of_cell[i])];
  }
  EXPECT_EQ(cells, blocks.cells);
  const auto block_at = [&](double x, double y) {
    return blocks.of_cell[shop.raster().cell_at({x, y}).value()];
  };
  EXPECT_EQ(block_at(1.0, 59.0), block_at(24.0, 33.0));
  EXPECT_EQ(block_at(36.0, 59.0), block_at(59.0, 33.0));
  EXPECT_EQ(block_at(1.0, 1.0), block_at(59.0, 27.0));
  EXPECT_NE(block_at(24.0, 40.0), block_at(36.0, 40.0));
  EXPECT_NE(block_at(24.0, 40.0), block_at(24.0, 20.0));
}

TEST(RowBlocks, AreOneWhereRowsRunToAndFro) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  EXPECT_TRUE(row_blocks({}, kEast, shop.raster()).lines.empty());
  const std::vector<SurveyCurve> lines{straight_curve({1.0, 5.0}, {59.0, 5.0}),
                                       straight_curve({59.0, 20.0}, {1.0, 20.0})};
  EXPECT_EQ(row_blocks(lines, kEast, shop.raster()).lines.size(), 1U);
}

TEST(RowBlocks, CutLinesAtTheCellsOfOthers) {
  const TwoBasins site;
  LineWorkshop shop(site.ground, site.options);
  const RowBlocks blocks = row_blocks(rows(shop, kEast), kEast, shop.raster());
  const std::vector<SurveyCurve> across{straight_curve({12.0, 1.0}, {12.0, 59.0})};
  double sum = 0.0;
  for (std::int32_t b = 0; b < 3; ++b) {
    const auto parts = cut_to_block(across, blocks, b, shop.raster(), 1.0);
    for (const SurveyCurve& part : parts) {
      sum += length_m(part);
      for (const Vec2& p : part.points) {
        EXPECT_EQ(blocks.of_cell[shop.raster().cell_at(p).value()], b);
      }
    }
  }
  EXPECT_NEAR(sum, 58.0, 2.0 * shop.raster().cell_m());
  EXPECT_TRUE(cut_to_block(across, blocks, 0, shop.raster(), 60.0).empty());
}

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
  site.options.heading = kEast;
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

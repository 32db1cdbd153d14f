#include "coverage/covered/covered_before.h"

#include <gtest/gtest.h>

#include "coverage/scenes.h"

namespace swathplan {
namespace {

using testing::rectangle;

TEST(CellOutlines, FollowCellsAndTheirHoles) {
  // A ring of cells with a hole, and a cell that touches it at a corner only.
  const std::vector<std::uint8_t> marked{1, 1, 1, 0,  //
                                         1, 0, 1, 0,  //
                                         1, 1, 1, 0,  //
                                         0, 0, 0, 1};
  const Area area = outlines(marked, {Vec2(10, 20), 2.0, 4, 4});
  EXPECT_NEAR(area_m2(area), 4.0 * 9, 1e-6);
  EXPECT_FALSE(contains(area, Vec2(13, 23)));
  EXPECT_TRUE(contains(area, Vec2(17, 27)));
  EXPECT_TRUE(outlines({0, 0, 0, 0}, {Vec2(0, 0), 1.0, 2, 2}).empty());
}

TEST(CellOutlines, AgreeWithEachCellOfRandomMarks) {
  std::mt19937 random(3);
  const CellLattice lattice{Vec2(-3, 5), 0.5, 23, 17};
  std::vector<std::uint8_t> marked(lattice.columns * lattice.rows);
  for (auto& m : marked) m = random() % 3 == 0 ? 0 : 1;
  const Area area = outlines(marked, lattice);
  std::size_t n = 0;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    const Vec2 centre = lattice.origin + 0.5 * Vec2(0.5 + static_cast<double>(i % lattice.columns),
                                                    0.5 + static_cast<double>(i / lattice.columns));
    EXPECT_EQ(contains(area, centre), marked[i] != 0) << i;
    n += marked[i];
  }
  EXPECT_NEAR(area_m2(area), 0.25 * static_cast<double>(n), 1e-6);
}

TEST(CoveredBefore, AHalfIsLeftOfAnAreaThatWasHalfCovered) {
  CoveredBefore before(rectangle(0, 0, 100, 60), 1.0, 1);
  before.cover(rectangle(-20, -20, 40, 200));
  EXPECT_EQ(before.cells(), 6000U);
  EXPECT_EQ(before.covered_cells(), 2400U);
  const Rest rest = before.rest(1.0);
  EXPECT_NEAR(area_m2(rest.area), 3600.0, 1e-3);
  EXPECT_EQ(rest.gaps, 0U);
}

TEST(CoveredBefore, ASlantingEdgeIsRoundedToFewCorners) {
  CoveredBefore before(rectangle(0, 0, 100, 100), 1.0, 1);
  before.cover(Area{{{{0, 0}, {100, 0}, {100, 37}, {0, 3}}, {}}});
  const Rest rest = before.rest(1.0);
  ASSERT_EQ(rest.area.size(), 1U);
  EXPECT_LT(rest.area[0].outer.size(), 16U) << "steps of cells";
  EXPECT_NEAR(area_m2(rest.area), 10000.0 - 2000.0, 120.0);
}

TEST(CoveredBefore, SmallAndNarrowGapsAreCountedButNotLeft) {
  CoveredBefore holed(rectangle(0, 0, 60, 60), 1.0, 1);
  Area done = rectangle(0, 0, 60, 60);
  done = subtract(done, rectangle(10, 10, 20, 20));  // a hole worth a line
  done = subtract(done, rectangle(30, 0, 32, 60));   // too narrow
  done = subtract(done, rectangle(40, 40, 43, 43));  // too small for 10 square metres
  holed.cover(done);
  const Rest rest = holed.rest(10.0);
  EXPECT_NEAR(area_m2(rest.area), 100.0, 1e-3);
  EXPECT_EQ(rest.gaps, 2U);
  EXPECT_NEAR(rest.gaps_m2, 120.0 + 9.0, 1e-9);
  EXPECT_NEAR(area_m2(holed.rest(5.0).area), 109.0, 1e-3);
}

TEST(CoveredBefore, NothingIsLeftOfWhatIsCovered) {
  CoveredBefore before(rectangle(0, 0, 20, 20), 1.0, 1);
  before.cover(rectangle(-1, -1, 21, 21));
  EXPECT_TRUE(before.rest(0.0).area.empty());
}

TEST(CoveredBefore, ATrackCoversItsStripAsFarAsItsEnds) {
  CoveredBefore before(rectangle(0, 0, 100, 40), 1.0, 1);
  before.cover({{20, 20}, {80, 20}}, 10.0);
  EXPECT_EQ(before.covered_cells(), 600U);
  CoveredBefore bent(rectangle(0, 0, 100, 100), 1.0, 1);
  bent.cover({{20, 20}, {60, 20}, {60, 60}}, 10.0);
  EXPECT_TRUE(bent.covered(*bent.cell_at(Vec2(63.5, 16.5)))) << "round the outside of the bend";
  EXPECT_FALSE(bent.covered(*bent.cell_at(Vec2(18.5, 20.5))));
}

TEST(CoveredBefore, SoundingsAddUpToWhatIsWanted) {
  const Area area = rectangle(0, 0, 10, 10);
  CoveredBefore before(area, 1.0, 5);
  const auto cell = *before.cell_at(Vec2(3.5, 3.5));
  before.add(cell, 3);
  EXPECT_FALSE(before.covered(cell));
  before.add(cell, 2);
  EXPECT_TRUE(before.covered(cell));
  EXPECT_FALSE(before.cell_at(Vec2(-0.5, 3)));
}

TEST(CoveredBefore, TheWholeCountsEarlierCellsAndThoseOfTheRoute) {
  const Area whole = rectangle(0.3, 0.7, 100.3, 60.7);
  CoveredBefore before(whole, 1.0, 1);
  before.cover(rectangle(-20, -20, 40.3, 200));
  const Rest rest = before.rest(1.0);
  CoverageGrid scored(rest.area, 1.0, before.grid().origin());
  ASSERT_NEAR((scored.origin() - Vec2(40.3, 0.7)).norm(), 0.0, 1e-9);
  // 30 of the 60 rows are hit, half of them by logged pings.
  for (std::size_t i = 0; i < std::size_t{30} * scored.columns(); ++i) {
    scored.words()[i] |= 1U;
    if (i < std::size_t{15} * scored.columns()) scored.words()[i] |= 1U << 16U;
  }
  const WholeFigures figures = before.whole(scored, rest);
  EXPECT_EQ(figures.cells, 6000U);
  EXPECT_NEAR(figures.area_m2, 6000.0, 1e-6);
  EXPECT_NEAR(figures.before_pct, 40.0, 1e-9);
  EXPECT_NEAR(figures.all_pct, 70.0, 1e-9);
  EXPECT_NEAR(figures.logged_pct, 55.0, 1e-9);
}

TEST(CoverageGrid, PartsOfAnAreaHaveTheCellsOfItsLattice) {
  const CoverageGrid part(rectangle(5.2, 7.9, 9.0, 9.1), 0.5, Vec2(1.1, 1.2));
  EXPECT_NEAR((part.origin() - Vec2(5.1, 7.7)).norm(), 0.0, 1e-12);
  EXPECT_EQ(part.columns(), 8U);
  EXPECT_EQ(part.rows(), 3U);
  // A corner that lies on the lattice but for rounding is a corner of the grid.
  const CoverageGrid on(rectangle(0.3 + 3 * 0.1, 0, 2, 1), 0.1, Vec2(0.3, 0));
  EXPECT_NEAR(on.origin().x(), 0.6, 1e-12);
}

}  // namespace
}  // namespace swathplan

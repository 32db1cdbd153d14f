#include "coverage/tracing/coverage_grid.h"

#include <gtest/gtest.h>

#include "coverage/scenes.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

std::size_t counting(const CoverageGrid& grid) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < grid.words().size(); ++i) n += grid.counts(i);
  return n;
}

TEST(CoverageGrid, StartsAtTheLowerLeftCornerOfTheArea) {
  const CoverageGrid grid(testing::rectangle(-40, -40, 40, 40), 0.1);
  EXPECT_EQ(grid.columns(), 800U);
  EXPECT_EQ(grid.rows(), 800U);
  EXPECT_EQ(counting(grid), 640000U);
  EXPECT_EQ(grid.origin(), Vec2(-40, -40));
  EXPECT_NEAR((grid.centre(0, 1) - Vec2(-39.95, -39.85)).norm(), 0, 1e-12);
}

TEST(CoverageGrid, AnExtentThatIsNoWholeNumberOfCellsGetsOneMore) {
  const CoverageGrid grid(testing::rectangle(0, 0, 1.04, 0.26), 0.1);
  EXPECT_EQ(grid.columns(), 11U);
  EXPECT_EQ(grid.rows(), 3U);
  // The centres at x = 1.05 lie outside; those at y = 0.25 inside.
  EXPECT_EQ(counting(grid), 30U);
}

TEST(CoverageGrid, ACentreOnTheOutlineCounts) {
  // Centres at 0.5, 1.5, ...: the outline and the hole run through them.
  Area area = testing::rectangle(0, 0, 5.5, 5.5);
  EXPECT_EQ(counting(CoverageGrid(area, 1.0)), 36U);
  area[0].holes.push_back({{1.5, 1.5}, {1.5, 3.5}, {3.5, 3.5}, {3.5, 1.5}});
  EXPECT_EQ(counting(CoverageGrid(area, 1.0)), 35U);
}

TEST(CoverageGrid, AgreesWithAPointTestOnJaggedAreasWithHoles) {
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int trial = 0; trial < 20; ++trial) {
    Polygon polygon;
    const int n = 3 + trial;
    Ring hole;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * i / n;
      polygon.outer.emplace_back(std::cos(a) * (5 + 4 * uniform()),
                                 std::sin(a) * (5 + 4 * uniform()));
      hole.emplace_back(std::cos(-a) * 2 * uniform(), std::sin(-a) * 2 * uniform());
    }
    polygon.holes.push_back(hole);
    const Area area{polygon};
    const CoverageGrid grid(area, 0.25);
    for (std::uint32_t r = 0; r < grid.rows(); ++r) {
      for (std::uint32_t c = 0; c < grid.columns(); ++c) {
        EXPECT_EQ(grid.counts(std::size_t{r} * grid.columns() + c),
                  contains(area, grid.centre(c, r)))
            << trial << ' ' << c << ' ' << r;
      }
    }
  }
}

TEST(CoverageGrid, RefusesAResolutionThatIsNotPositiveOrTooFine) {
  const Area area = testing::rectangle(0, 0, 1000, 1000);
  EXPECT_THROW(CoverageGrid(area, 0.0), UsageError);
  EXPECT_THROW(CoverageGrid(area, -0.1), UsageError);
  EXPECT_THROW(CoverageGrid(area, std::nan("")), UsageError);
  EXPECT_THROW(CoverageGrid({}, 0.1), InvalidInput);
  try {
    const CoverageGrid grid(area, 0.001);
    FAIL() << "accepted";
  } catch (const UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("1000000 x 1000000"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("2e+09"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace swathplan

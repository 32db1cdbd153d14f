#include "io/pictures/coverage_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/pictures/random_grid.h"

namespace swathplan {
namespace {

/// What a pixel must be, straight from the definition.
std::uint8_t expected_index(const CoverageGrid& grid, std::uint32_t factor, std::uint32_t pc,
                            std::uint32_t pr_south) {
  double cells = 0, empty = 0, soundings = 0;
  for (std::uint32_t r = pr_south * factor; r < std::min(grid.rows(), (pr_south + 1) * factor);
       ++r) {
    for (std::uint32_t c = pc * factor; c < std::min(grid.columns(), (pc + 1) * factor); ++c) {
      const std::size_t i = std::size_t{r} * grid.columns() + c;
      if (!grid.counts(i)) continue;
      ++cells;
      empty += grid.soundings(i) == 0 ? 1 : 0;
      soundings += grid.soundings(i);
    }
  }
  if (cells == 0) return 0;
  if (empty > 0) {
    return static_cast<std::uint8_t>(kEmpty + std::ceil(20.0 * empty / cells - 1e-9));
  }
  int level = 0;
  for (const double limit : kCoveredLimits) level += soundings / cells >= limit ? 1 : 0;
  return static_cast<std::uint8_t>(kCovered + level);
}

TEST(CoverageSummary, AgreesWithTheDefinitionAtEveryScale) {
  const CoverageGrid grid = test::random_grid(0.5, 2);  // 60 x 80 cells
  for (const std::uint32_t side : {7U, 23U, 40U, 79U, 80U, 1000U}) {
    const CoverageSummary summary = summarise(grid, side);
    EXPECT_LE(std::max(summary.columns, summary.rows), side);
    for (std::uint32_t r = 0; r < summary.rows; ++r) {
      for (std::uint32_t c = 0; c < summary.columns; ++c) {
        ASSERT_EQ(summary.pixels[std::size_t{r} * summary.columns + c],
                  expected_index(grid, summary.factor, c, summary.rows - 1 - r))
            << side << ": " << c << "," << r;
      }
    }
  }
}

TEST(CoverageSummary, NeverLosesASingleEmptyCell) {
  CoverageGrid grid(test::kCutSquare, 0.1);
  for (std::uint32_t& word : grid.words()) word |= 3U;
  const std::size_t lonely = std::size_t{200} * grid.columns() + 150;
  grid.words()[lonely] &= ~CoverageGrid::kCountMask;
  const CoverageSummary summary = summarise(grid, 8);
  const auto gaps = std::count_if(summary.pixels.begin(), summary.pixels.end(),
                                  [](std::uint8_t index) { return index > kEmpty; });
  EXPECT_EQ(gaps, 1);
}

TEST(CoverageSummary, ColoursTellCoveredFromEmptyAndEachIndexFromTheOthers) {
  const std::vector<Rgba> palette = coverage_palette();
  EXPECT_EQ(palette[0].a, 0);
  for (std::size_t i = kCovered; i < palette.size(); ++i) {
    const bool covered = i < kCovered + kCoveredNames.size();
    if (!covered && i <= kEmpty) continue;
    EXPECT_EQ(palette[i].b > palette[i].r, covered) << i;
    for (std::size_t k = kCovered; k < i; ++k) EXPECT_FALSE(palette[i] == palette[k]);
  }
}

TEST(CoverageSummary, TakesWhatNoLoggedPingSoundedAsEmptyWhereTheseCount) {
  CoverageGrid grid({{{{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {}}}, 1.0);
  grid.words()[1] |= 6U;
  grid.words()[2] |= 6U | 2U << CoverageGrid::kLoggedShift;
  const std::uint8_t empty = kEmpty + kEmptySteps, six = kCovered + 3;
  EXPECT_EQ(summarise(grid, 10).pixels, (std::vector<std::uint8_t>{empty, six, six}));
  EXPECT_EQ(summarise(grid, 10, true).pixels, (std::vector<std::uint8_t>{empty, empty, six}));
}

}  // namespace
}  // namespace swathplan

#include "io/pictures/coverage_raster.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <random>

#include "io/pictures/coverage_summary.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;
using internal::CoverageSummary;

const Area kArea{{.outer = {{2, 3}, {32, 3}, {32, 43}, {12, 43}, {2, 33}}, .holes = {}}};

/// Random soundings, a third of the cells empty.
CoverageGrid random_grid(double resolution_m, unsigned seed) {
  CoverageGrid grid(kArea, resolution_m);
  std::minstd_rand random(seed);
  for (std::uint32_t& word : grid.words()) {
    if ((word & CoverageGrid::kInArea) != 0 && random() % 3 != 0) {
      word |= static_cast<std::uint32_t>(1U + random() % 30U);
    }
  }
  return grid;
}

TEST(CoverageTif, ReadsBackCellByCellWithPlaceAndCrs) {
  const fs::path path = fs::path(testing::TempDir()) / "swathplan_coverage.tif";
  CoverageGrid grid = random_grid(0.5, 1);
  grid.words()[grid.words().size() / 2] |= CoverageGrid::kCountMask;  // the largest count
  const Frame frame = test::utm_frame();
  write_coverage_tif(path, grid, frame);
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> read(
      GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_ReadOnly)));
  ASSERT_NE(read, nullptr);
  ASSERT_EQ(read->GetRasterXSize(), static_cast<int>(grid.columns()));
  ASSERT_EQ(read->GetRasterYSize(), static_cast<int>(grid.rows()));
  EXPECT_EQ(read->GetRasterBand(1)->GetNoDataValue(), kCoverageNodata);
  EXPECT_EQ(read->GetRasterBand(1)->GetRasterDataType(), GDT_UInt16);
  EXPECT_STREQ(read->GetSpatialRef()->GetAuthorityCode(nullptr), "32633");
  double t[6];
  ASSERT_EQ(read->GetGeoTransform(t), CE_None);
  std::vector<std::uint16_t> values(grid.words().size());
  ASSERT_EQ(read->GetRasterBand(1)->RasterIO(
                GF_Read, 0, 0, read->GetRasterXSize(), read->GetRasterYSize(), values.data(),
                read->GetRasterXSize(), read->GetRasterYSize(), GDT_UInt16, 0, 0),
            CE_None);
  for (std::uint32_t r = 0; r < grid.rows(); ++r) {
    for (std::uint32_t c = 0; c < grid.columns(); ++c) {
      const std::size_t i = std::size_t{r} * grid.columns() + c;
      const std::uint32_t picture_row = grid.rows() - 1 - r;
      const std::uint16_t value = values[std::size_t{picture_row} * grid.columns() + c];
      const std::uint32_t wanted =
          grid.counts(i) ? std::min<std::uint32_t>(grid.soundings(i), 65534U) : kCoverageNodata;
      ASSERT_EQ(value, wanted) << c << "," << r;
      const Vec2 at(t[0] + t[1] * (c + 0.5), t[3] + t[5] * (picture_row + 0.5));
      ASSERT_LT((at - frame.to_file(grid.centre(c, r))).norm(), 1e-6);
    }
  }
  fs::remove(path);
}

TEST(CoverageTif, NamesAFileThatCannotBeWritten) {
  EXPECT_THAT([] { write_coverage_tif("/dev/null/x.tif", random_grid(1.0, 1), {}); },
              testing::ThrowsMessage<InvalidInput>(testing::HasSubstr("/dev/null")));
}

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
    return static_cast<std::uint8_t>(internal::kEmpty + std::ceil(20.0 * empty / cells - 1e-9));
  }
  int level = 0;
  for (const double limit : internal::kCoveredLimits) level += soundings / cells >= limit ? 1 : 0;
  return static_cast<std::uint8_t>(internal::kCovered + level);
}

TEST(CoverageSummary, AgreesWithTheDefinitionAtEveryScale) {
  const CoverageGrid grid = random_grid(0.5, 2);  // 60 x 80 cells
  for (const std::uint32_t side : {7U, 23U, 40U, 79U, 80U, 1000U}) {
    const CoverageSummary summary = internal::summarise(grid, side);
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
  CoverageGrid grid(kArea, 0.1);
  for (std::uint32_t& word : grid.words()) word |= 3U;
  const std::size_t lonely = std::size_t{200} * grid.columns() + 150;
  grid.words()[lonely] &= ~CoverageGrid::kCountMask;
  const CoverageSummary summary = internal::summarise(grid, 8);
  const auto gaps = std::count_if(summary.pixels.begin(), summary.pixels.end(),
                                  [](std::uint8_t index) { return index > internal::kEmpty; });
  EXPECT_EQ(gaps, 1);
}

TEST(CoverageSummary, ColoursTellCoveredFromEmptyAndEachIndexFromTheOthers) {
  const std::vector<internal::Rgba> palette = internal::coverage_palette();
  EXPECT_EQ(palette[0].a, 0);
  for (std::size_t i = internal::kCovered; i < palette.size(); ++i) {
    const bool covered = i < internal::kCovered + internal::kCoveredNames.size();
    if (!covered && i <= internal::kEmpty) continue;
    EXPECT_EQ(palette[i].b > palette[i].r, covered) << i;
    for (std::size_t k = internal::kCovered; k < i; ++k) EXPECT_FALSE(palette[i] == palette[k]);
  }
}

TEST(CoveragePng, IsAPictureOfBoundedSize) {
  const fs::path path = fs::path(testing::TempDir()) / "swathplan_coverage.png";
  for (const double resolution : {2.0, 0.01}) {
    write_coverage_png(path, random_grid(resolution, 3), "Rønne 0.10 m");
    GDALAllRegister();
    const std::unique_ptr<GDALDataset> read(
        GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_ReadOnly)));
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(read->GetRasterCount(), 3);
    EXPECT_GE(read->GetRasterXSize(), 900);
    EXPECT_LE(read->GetRasterXSize(), 2400);
    EXPECT_LE(read->GetRasterYSize(), 2450);
  }
  fs::remove(path);
}

}  // namespace
}  // namespace swathplan

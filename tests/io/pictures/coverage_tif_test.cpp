#include "io/pictures/coverage_tif.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "io/pictures/random_grid.h"
#include "io/sample_plan.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

TEST(CoverageTif, ReadsBackCellByCellWithPlaceAndCrs) {
  const fs::path path = fs::path(testing::TempDir()) / "swathplan_coverage.tif";
  CoverageGrid grid = test::random_grid(0.5, 1);
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
  EXPECT_THAT([] { write_coverage_tif("/dev/null/x.tif", test::random_grid(1.0, 1), {}); },
              testing::ThrowsMessage<InvalidInput>(testing::HasSubstr("/dev/null")));
}

}  // namespace
}  // namespace swathplan

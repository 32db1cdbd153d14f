#include "io/pictures/coverage_png.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "io/pictures/random_grid.h"

namespace swathplan {
namespace {

namespace fs = std::filesystem;

TEST(CoveragePng, IsAPictureOfBoundedSize) {
  const fs::path path = fs::path(testing::TempDir()) / "swathplan_coverage.png";
  for (const double resolution : {2.0, 0.01}) {
    write_coverage_png(path, test::random_grid(resolution, 3), "Rønne 0.10 m");
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

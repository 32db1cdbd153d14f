#include "io/pictures/lines_png.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "io/files/gdal_at_home.h"
#include "mesh/base/error.h"
#include "mesh/synthetic.h"
#include "planners/test_site.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

TEST(LinesPng, ShowsInRedWhatTheLinesMiss) {
  const TestSite site(flat(200.0, 100.0, 10.0));
  const WaterRaster raster(site.ground);
  const std::vector<float> width = opening_width(raster, Angle::degrees(90.0), 0.0);
  const SweptGround ground(raster, width, 0.0);
  const std::vector<SurveyCurve> curves{{.points = {{0.0, 50.0}, {200.0, 50.0}}}};
  const test::TemporaryFolder folder;
  write_lines_png(folder.path() / "lines.png", ground, swept(curves, ground), "one line\n10 m");
  register_gdal();
  const std::unique_ptr<GDALDataset> read(
      GDALDataset::FromHandle(GDALOpen((folder.path() / "lines.png").c_str(), GA_ReadOnly)));
  ASSERT_NE(read, nullptr);
  ASSERT_EQ(read->GetRasterCount(), 3);
  const int columns = read->GetRasterXSize(), rows = read->GetRasterYSize();
  EXPECT_GE(columns, kLinesPictureSide);
  std::vector<std::vector<std::uint8_t>> band(
      3, std::vector<std::uint8_t>(static_cast<std::size_t>(columns * rows)));
  for (std::size_t b = 0; b < 3; ++b) {
    ASSERT_EQ(
        read->GetRasterBand(static_cast<int>(b) + 1)
            ->RasterIO(GF_Read, 0, 0, columns, rows, band[b].data(), columns, rows, GDT_Byte, 0, 0),
        CE_None);
  }
  double red = 0.0;
  for (std::size_t i = 0; i < band[0].size(); ++i) {
    red += band[0][i] == 214 && band[1][i] == 48 && band[2][i] == 48 ? 1.0 : 0.0;
  }
  // The line sweeps 20 m of 100; a pixel is about 200 m / 1100.
  EXPECT_NEAR(red, 0.8 * kLinesPictureSide * kLinesPictureSide / 2.0,
              0.05 * kLinesPictureSide * kLinesPictureSide);
}

TEST(LinesPng, NamesAFileThatCannotBeWritten) {
  const TestSite site(flat(40.0, 40.0, 10.0));
  const WaterRaster raster(site.ground);
  const std::vector<float> width = opening_width(raster, Angle::degrees(90.0), 0.0);
  const SweptGround ground(raster, width, 0.0);
  EXPECT_THROW(write_lines_png("/dev/null/lines.png", ground, {}, ""), InvalidInput);
}

}  // namespace
}  // namespace swathplan

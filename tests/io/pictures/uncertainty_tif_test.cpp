#include "io/pictures/uncertainty_tif.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <memory>

#include "io/sample_judged.h"
#include "mesh/base/error.h"
#include "temporary_folder.h"

namespace swathplan {
namespace {

std::vector<float> values_of(const std::filesystem::path& path, double (&transform)[6]) {
  GDALAllRegister();
  const std::unique_ptr<GDALDataset> read(
      GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_ReadOnly)));
  std::vector<float> values(6);
  EXPECT_EQ(read->GetRasterBand(1)->GetNoDataValue(), kUncertaintyNodata);
  EXPECT_EQ(read->GetGeoTransform(transform), CE_None);
  EXPECT_EQ(
      read->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 3, 2, values.data(), 3, 2, GDT_Float32, 0, 0),
      CE_None);
  return values;
}

TEST(UncertaintyTif, ReadsBackNorthUp) {
  const test::TemporaryFolder folder;
  const UncertaintyRaster raster = test::judged_survey().raster;
  Frame frame;
  frame.origin = {100.0, 200.0};
  double transform[6];
  write_tvu_tif(folder.path() / "tvu.tif", raster, frame);
  EXPECT_THAT(values_of(folder.path() / "tvu.tif", transform),
              ::testing::ElementsAre(0.4F, 0.5F, kUncertaintyNodata, 0.1F, 0.2F, 0.3F));
  EXPECT_EQ(transform[0], 100.0);
  EXPECT_EQ(transform[3], 201.0);
  EXPECT_EQ(transform[1], 0.5);
  write_thu_tif(folder.path() / "thu.tif", raster, frame);
  EXPECT_THAT(values_of(folder.path() / "thu.tif", transform),
              ::testing::ElementsAre(1.4F, 1.5F, kUncertaintyNodata, 1.1F, 1.2F, 1.3F));
}

TEST(UncertaintyTif, SaysWhatItCannotWrite) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "tvu.tif");
  EXPECT_THROW(write_tvu_tif(folder.path() / "tvu.tif", test::judged_survey().raster, {}),
               InvalidInput);
}

}  // namespace
}  // namespace swathplan

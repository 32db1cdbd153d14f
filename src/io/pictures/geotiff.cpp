#include <cpl_string.h>
#include <fmt/format.h>

#include <memory>

#include "io/files/atomic_file.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "io/pictures/geotiff_internal.h"
#include "mesh/base/error.h"

namespace swathplan::internal {
namespace {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw InvalidInput(
      fmt::format("cannot write '{}'{}: check that the folder is writable and the "
                  "disk has room",
                  path.string(), QuietGdal::why()));
}

Dataset create(const std::string& part, const RasterFile& raster) {
  register_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", raster.predictor);
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  return Dataset(driver == nullptr ? nullptr
                                   : driver->Create(part.c_str(), static_cast<int>(raster.columns),
                                                    static_cast<int>(raster.rows), 1, raster.type,
                                                    options.List()));
}

void georeference(GDALDataset& dataset, const RasterFile& raster, const Frame& frame) {
  const double cell = raster.cell_m / frame.metres_per_unit;
  const Vec2 top_left = frame.to_file(raster.origin + Vec2(0.0, raster.cell_m * raster.rows));
  double transform[6] = {top_left.x(), cell, 0.0, top_left.y(), 0.0, -cell};
  dataset.SetGeoTransform(transform);
  if (frame.crs_wkt.empty()) return;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromWkt(frame.crs_wkt.c_str()) == OGRERR_NONE) dataset.SetSpatialRef(&crs);
}

}  // namespace

void write_geotiff(const std::filesystem::path& path, const RasterFile& raster, const Frame& frame,
                   const std::function<void*(std::uint32_t row)>& line) {
  const QuietGdal quiet;
  write_through_memory(path, [&](const std::string& part) {
    const Dataset dataset = create(part, raster);
    if (!dataset) fail(path);
    georeference(*dataset, raster, frame);
    GDALRasterBand* band = dataset->GetRasterBand(1);
    band->SetNoDataValue(raster.nodata);
    band->SetDescription(raster.band.c_str());
    const int width = static_cast<int>(raster.columns);
    for (std::uint32_t row = 0; row < raster.rows; ++row) {
      if (band->RasterIO(GF_Write, 0, static_cast<int>(row), width, 1, line(raster.rows - 1 - row),
                         width, 1, raster.type, 0, 0) != CE_None) {
        fail(path);
      }
    }
    if (dataset->FlushCache(); CPLGetLastErrorType() >= CE_Failure) fail(path);
  });
}

}  // namespace swathplan::internal

#include "io/pictures/coverage_tif.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <memory>

#include "io/files/atomic_file.h"
#include "io/files/gdal_at_home.h"
#include "io/files/quiet_gdal.h"
#include "mesh/base/error.h"

namespace swathplan {
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

Dataset create(const std::filesystem::path& part, const CoverageGrid& grid) {
  register_gdal();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "2");
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  return Dataset(driver == nullptr ? nullptr
                                   : driver->Create(part.c_str(), static_cast<int>(grid.columns()),
                                                    static_cast<int>(grid.rows()), 1, GDT_UInt16,
                                                    options.List()));
}

void georeference(GDALDataset& dataset, const CoverageGrid& grid, const Frame& frame) {
  const double cell = grid.resolution_m() / frame.metres_per_unit;
  const Vec2 top_left = frame.to_file(grid.origin() + Vec2(0.0, grid.resolution_m() * grid.rows()));
  double transform[6] = {top_left.x(), cell, 0.0, top_left.y(), 0.0, -cell};
  dataset.SetGeoTransform(transform);
  if (frame.crs_wkt.empty()) return;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromWkt(frame.crs_wkt.c_str()) == OGRERR_NONE) dataset.SetSpatialRef(&crs);
}

void fill_row(const CoverageGrid& grid, std::uint32_t row, std::vector<std::uint16_t>& line) {
  const std::size_t start = std::size_t{row} * grid.columns();
  for (std::uint32_t column = 0; column < grid.columns(); ++column) {
    const std::size_t i = start + column;
    line[column] = grid.counts(i) ? static_cast<std::uint16_t>(std::min<std::uint32_t>(
                                        grid.soundings(i), kCoverageNodata - 1U))
                                  : kCoverageNodata;
  }
}

}  // namespace

void write_coverage_tif(const std::filesystem::path& path, const CoverageGrid& grid,
                        const Frame& frame) {
  const QuietGdal quiet;
  write_atomically(path, [&](const std::filesystem::path& part) {
    const Dataset dataset = create(part, grid);
    if (!dataset) fail(path);
    georeference(*dataset, grid, frame);
    GDALRasterBand* band = dataset->GetRasterBand(1);
    band->SetNoDataValue(kCoverageNodata);
    band->SetDescription("soundings per cell");
    std::vector<std::uint16_t> line(grid.columns());
    const int width = static_cast<int>(grid.columns());
    for (std::uint32_t row = 0; row < grid.rows(); ++row) {
      fill_row(grid, grid.rows() - 1 - row, line);
      if (band->RasterIO(GF_Write, 0, static_cast<int>(row), width, 1, line.data(), width, 1,
                         GDT_UInt16, 0, 0) != CE_None) {
        fail(path);
      }
    }
    if (dataset->FlushCache(); CPLGetLastErrorType() >= CE_Failure) fail(path);
  });
}

}  // namespace swathplan

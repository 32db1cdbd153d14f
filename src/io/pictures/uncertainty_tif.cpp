#include "io/pictures/uncertainty_tif.h"

#include <algorithm>
#include <cmath>

#include "io/pictures/geotiff_internal.h"

namespace swathplan {
namespace {

void write_floats(const std::filesystem::path& path, const UncertaintyRaster& grid,
                  const std::vector<float>& values, const char* band, const Frame& frame) {
  internal::RasterFile raster;
  raster.columns = grid.columns;
  raster.rows = grid.rows;
  raster.cell_m = grid.cell_m;
  raster.origin = grid.origin;
  raster.type = GDT_Float32;
  raster.predictor = "3";
  raster.nodata = kUncertaintyNodata;
  raster.band = band;
  std::vector<float> line(grid.columns);
  internal::write_geotiff(path, raster, frame, [&](std::uint32_t row) -> void* {
    const auto first =
        values.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * grid.columns);
    std::transform(first, first + grid.columns, line.begin(),
                   [](float v) { return std::isinf(v) ? kUncertaintyNodata : v; });
    return line.data();
  });
}

}  // namespace

void write_tvu_tif(const std::filesystem::path& path, const UncertaintyRaster& raster,
                   const Frame& frame) {
  write_floats(path, raster, raster.tvu_m, "smallest TVU, metres at 95 %", frame);
}

void write_thu_tif(const std::filesystem::path& path, const UncertaintyRaster& raster,
                   const Frame& frame) {
  write_floats(path, raster, raster.thu_m, "smallest THU, metres at 95 %", frame);
}

}  // namespace swathplan

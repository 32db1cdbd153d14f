#include "io/pictures/coverage_tif.h"

#include <algorithm>

#include "io/pictures/geotiff_internal.h"

namespace swathplan {
namespace {

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
  internal::RasterFile raster;
  raster.columns = grid.columns();
  raster.rows = grid.rows();
  raster.cell_m = grid.resolution_m();
  raster.origin = grid.origin();
  raster.nodata = kCoverageNodata;
  raster.band = "soundings per cell";
  std::vector<std::uint16_t> line(grid.columns());
  internal::write_geotiff(path, raster, frame, [&](std::uint32_t row) -> void* {
    fill_row(grid, row, line);
    return line.data();
  });
}

}  // namespace swathplan

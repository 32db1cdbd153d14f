#pragma once

#include <gdal_priv.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "mesh/base/frame.h"

namespace swathplan::internal {

/// A grid of square cells, row 0 the southernmost, and how it is written.
struct RasterFile {
  std::uint32_t columns = 0, rows = 0;
  double cell_m = 1.0;
  Vec2 origin = Vec2::Zero();  ///< lower-left corner, local metres
  GDALDataType type = GDT_UInt16;
  const char* predictor = "2";  ///< of the compression: 2 for whole numbers, 3 for floats
  double nodata = 0.0;
  std::string band;  ///< what the cells hold
};

/// Writes a GeoTIFF of one band: north up, compressed, in the coordinates and CRS of the input
/// file. `line` gives the values of a row, of the file's type; they stay valid until the next call.
/// @throws InvalidInput if the file cannot be written.
void write_geotiff(const std::filesystem::path& path, const RasterFile& raster, const Frame& frame,
                   const std::function<void*(std::uint32_t row)>& line);

}  // namespace swathplan::internal

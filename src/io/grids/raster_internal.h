#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "io/grids/surface_data.h"

namespace swathplan {

/// The values of a grid as they stand in its file, row by row.
struct Raster {
  std::size_t columns = 0, rows = 0;
  std::array<double, 6> transform{};  ///< GDAL's: the corner of the first cell and the two steps
  std::vector<double> raw;
  double scale = 1.0, offset = 0.0;  ///< z = raw * scale + offset
  std::optional<double> nodata, more_nodata;

  /// NaN and the nodata values, these also as rounded to 32 bits: nodata of a 32-bit band is often
  /// written with more digits than the band holds.
  [[nodiscard]] bool is_nodata(double value) const;
};

/// @throws InvalidInput if the grid has more cells than kMostCells, or cells without an area.
void check_shape(const Raster& raster, const std::filesystem::path& path);

/// Joins the values to a surface: vertices, faces, spacing, and a note that counts the values.
/// @throws InvalidInput as read_grid() does.
[[nodiscard]] SurfaceData surface_of(const Raster& raster, const std::filesystem::path& path);

/// Cells that hold a value which programs use for 'no data' (-9999, 32767, 1e6, ...) without the
/// file saying so: turned to NaN where they lie far outside all other values, and warned about.
void drop_undeclared_nodata(Raster& raster, std::vector<std::string>& warnings);

}  // namespace swathplan

#pragma once

#include <cstdint>
#include <vector>

#include "mesh/base/angle.h"
#include "planners/fronts/survey_curve.h"
#include "planners/fronts/water_raster.h"

namespace swathplan {

/// Parts of the survey area (basins, and the water between them) in which the rows of one direction
/// can be sailed to and fro.
struct RowBlocks {
  static constexpr std::int32_t kNone = -1;
  std::vector<std::vector<std::size_t>> lines;  ///< of each block, in the order of its rows
  std::vector<std::int32_t> of_cell;            ///< per cell of the raster; kNone outside the area
  std::vector<std::size_t> cells;               ///< of each block
};

/// Divides straight `lines` at `azimuth` into blocks. Lines of neighbouring rows that overlap one
/// to one belong to one block. Where a line splits into two, or two lines meet, a new block begins.
/// A cell belongs to the block of the nearest line of the nearest row. O(cells x lines of a row).
[[nodiscard]] RowBlocks row_blocks(const std::vector<SurveyCurve>& lines, Angle azimuth,
                                   const WaterRaster& raster);

/// The parts of straight lines outside the cells of other blocks, those of at least `least_m`.
[[nodiscard]] std::vector<SurveyCurve> cut_to_block(const std::vector<SurveyCurve>& lines,
                                                    const RowBlocks& blocks, std::int32_t block,
                                                    const WaterRaster& raster, double least_m);

}  // namespace swathplan

#pragma once

#include <cstdint>
#include <filesystem>

#include "coverage/tracing/coverage_grid.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// Writes the soundings per cell as a GeoTIFF: 16-bit, north up, compressed, in the coordinates and
/// CRS of the input file. Cells outside the survey area hold kCoverageNodata. Counts are capped one
/// below it.
/// @throws InvalidInput if the file cannot be written.
void write_coverage_tif(const std::filesystem::path& path, const CoverageGrid& grid,
                        const Frame& frame);
inline constexpr std::uint16_t kCoverageNodata = 65535;

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <string>

#include "coverage/tracing/coverage_grid.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// Soundings per cell as a GeoTIFF: 16-bit, north up, compressed, in the coordinates and CRS of
/// the input file; kCoverageNodata outside the survey area; larger counts are capped below it.
/// @throws InvalidInput if the file cannot be written.
void write_coverage_tif(const std::filesystem::path& path, const CoverageGrid& grid,
                        const Frame& frame);
inline constexpr std::uint16_t kCoverageNodata = 65535;

/// The coverage as a picture for people: covered cells by their soundings (blue), cells without
/// any (red), land and the outside blank, with a legend and a scale bar. A grid larger than
/// kPictureSide is drawn smaller; then a pixel shows the share of its cells that are empty, so that
/// no gap vanishes. `title` stands above (ASCII; other characters become '?').
/// @throws InvalidInput if the file cannot be written.
void write_coverage_png(const std::filesystem::path& path, const CoverageGrid& grid,
                        const std::string& title);
inline constexpr std::uint32_t kPictureSide = 2200;  ///< pixels, largest side of the map itself

}  // namespace swathplan

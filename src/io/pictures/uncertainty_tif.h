#pragma once

#include <filesystem>

#include "coverage/judging/judged_survey.h"
#include "mesh/base/frame.h"

namespace swathplan {

/// Writes the smallest TVU and THU of each scoring cell as GeoTIFFs, metres at 95 %: 32-bit floats,
/// north up, compressed, in the coordinates and CRS of the input file. Cells in which no sounding
/// of a logged line fell hold kUncertaintyNodata.
/// @throws InvalidInput if a file cannot be written.
void write_tvu_tif(const std::filesystem::path& path, const UncertaintyRaster& raster,
                   const Frame& frame);
void write_thu_tif(const std::filesystem::path& path, const UncertaintyRaster& raster,
                   const Frame& frame);
inline constexpr float kUncertaintyNodata = -9999.0F;

}  // namespace swathplan

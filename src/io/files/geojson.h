#pragma once

#include <string>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan::internal {

/// What a GeoJSON file of ours begins with, up to its first feature: where the frame has no CRS, a
/// `local_frame` member that says what the coordinates are.
[[nodiscard]] std::string geojson_head(const Frame& frame);
[[nodiscard]] inline std::string geojson_tail() { return "\n]}\n"; }

/// Local positions as GeoJSON positions: '[lon,lat]' (WGS84, to 0.1 mm), or '[x,y]' of the input
/// file without a CRS.
[[nodiscard]] std::vector<std::string> geojson_positions(const std::vector<Vec2>& local,
                                                         const Frame& frame);

/// 'stem.geojson', or 'stem.local.geojson' for metres.
[[nodiscard]] std::string geojson_name(const std::string& stem, const Frame& frame);

}  // namespace swathplan::internal

#pragma once

#include <string>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// The beginning of a GeoJSON file, up to its first feature. If the frame has no CRS, it holds a
/// `local_frame` member that says what the coordinates are.
[[nodiscard]] std::string geojson_head(const Frame& frame);
[[nodiscard]] inline std::string geojson_tail() { return "\n]}\n"; }

/// Local positions as GeoJSON positions, to a micrometre: '[lon,lat]' in WGS84, or '[x,y]' of the
/// input file if there is no CRS.
[[nodiscard]] std::vector<std::string> geojson_positions(const std::vector<Vec2>& local,
                                                         const Frame& frame);

/// 'stem.geojson', or 'stem.local.geojson' for metres.
[[nodiscard]] std::string geojson_name(const std::string& stem, const Frame& frame);

}  // namespace swathplan

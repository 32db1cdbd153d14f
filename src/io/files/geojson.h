#pragma once

#include <cstddef>
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

/// A place of a line in degrees, cut where the line crosses 180 degrees.
struct CutPlace {
  Vec2 lonlat = Vec2::Zero();
  std::size_t segment = 0;  ///< of the whole line: which segment leads on from here
};
/// A line of longitudes and latitudes in parts that do not cross 180 degrees (RFC 7946, 3.1.9); one
/// part if it does not cross.
[[nodiscard]] std::vector<std::vector<CutPlace>> cut_at_180(const std::vector<Vec2>& line);
/// The same for a ring without its closing point; parts without an area are left out.
[[nodiscard]] std::vector<std::vector<Vec2>> ring_cut_at_180(const std::vector<Vec2>& line);

/// '[lon,lat]' to a micrometre.
[[nodiscard]] std::string geojson_lonlat(const Vec2& lonlat);

/// 'stem.geojson', or 'stem.local.geojson' for metres.
[[nodiscard]] std::string geojson_name(const std::string& stem, const Frame& frame);

}  // namespace swathplan

#pragma once

#include <string>

#include "mesh/plane/box.h"

namespace swathplan {

/// How a projected CRS stands to the ground where the data lie.
enum class MapScale {
  true_to_ground,  ///< a unit is what it says, to kMapScaleSlack
  even,            ///< longer or shorter, but by the same factor everywhere and in all directions
  uneven           ///< by factors that differ with place or direction
};

/// A metre of the map may differ by this share from one on the ground; so may scales within the
/// data.
inline constexpr double kMapScaleSlack = 0.01;

struct MapScaleAtData {
  MapScale kind = MapScale::true_to_ground;
  double metres_per_unit = 1.0;  ///< on the ground, in the middle of the data
};

/// `data`: extent in the coordinates of `crs_wkt`, a projected CRS (Web Mercator doubles lengths at
/// 60 degrees of latitude, an equidistant cylindrical map those along parallels only).
[[nodiscard]] MapScaleAtData map_scale(const std::string& crs_wkt, const Box2& data);

}  // namespace swathplan

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// What a reader found in a file, in the file's own coordinates and units.
struct SurfaceData {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< empty: scattered points, not yet joined
  std::string crs_wkt;                              ///< the file's own CRS, WKT; empty: none
  std::string format;                               ///< for people: 'GTiff', 'OBJ', ...
  bool is_clean = false;    ///< faces join edge to edge by construction: no repair needed
  bool z_is_depth = false;  ///< the file says that z is positive down (a 'depth' column)
  std::optional<double> z_unit_m = {};   ///< metres in one unit of z, where the file says so
  std::optional<double> xy_unit_m = {};  ///< metres in one unit of x and y, where columns say so
  double spacing = 0.0;     ///< typical distance between neighbouring nodes, file units; 0: unknown
  double float_step = 0.0;  ///< rounding step of the largest coordinate, where stored in 32 bits
  std::vector<std::string> notes, warnings;
};

}  // namespace swathplan

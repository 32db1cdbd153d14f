#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace swathplan {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// The local frame: x east, y north, z up, in metres. The still water level is z = 0, the seafloor
/// has z < 0, depth is -z. An azimuth runs clockwise from north. The origin is given in the
/// horizontal coordinates of the input file. Local coordinates stay small, so that large ones, as
/// of UTM, lose no digits.
struct Frame {
  Vec2 origin = Vec2::Zero();    ///< the local origin in file coordinates (easting, northing)
  double metres_per_unit = 1.0;  ///< metres in one horizontal unit of the file (0.3048 for feet)
  std::string crs_wkt;           ///< projected CRS of the file coordinates, WKT; empty: local only

  /// File coordinates -> local metres.
  [[nodiscard]] Vec2 to_local(const Vec2& file) const { return (file - origin) * metres_per_unit; }
  /// Local metres -> file coordinates.
  [[nodiscard]] Vec2 to_file(const Vec2& local) const { return local / metres_per_unit + origin; }
};

}  // namespace swathplan

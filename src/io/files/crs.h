#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

// A CRS is a WKT 2 text throughout; an empty text is "none: local coordinates". Axis order is the
// traditional one of GIS everywhere: x = easting or longitude, y = northing or latitude.

/// 'EPSG:n', WKT or anything else that PROJ reads -> WKT 2, its vertical part left out.
/// @throws UsageError if PROJ cannot read it.
[[nodiscard]] std::string parse_crs(const std::string& text);

/// True if the horizontal coordinates are degrees.
[[nodiscard]] bool is_geographic(const std::string& wkt);
/// True if the horizontal coordinates are lengths on a map projection.
[[nodiscard]] bool is_projected(const std::string& wkt);
/// Metres in one horizontal unit (0.3048 for feet); 1 for none and for degrees.
[[nodiscard]] double metres_per_unit(const std::string& wkt);
/// Metres on the ground in one horizontal unit of a projected CRS at a place, along its axes.
struct GroundScale {
  double along_x = 1.0, along_y = 1.0;
};
/// The scale at a place on the WGS 84 ellipsoid, to about 1e-6. `wkt` must be projected.
/// @throws InvalidInput where the place has no longitude and latitude.
[[nodiscard]] GroundScale ground_scale(const std::string& wkt, const Vec2& at);
/// The true azimuth of the grid's north at a place of a projected CRS (meridian convergence),
/// degrees; above 0 where grid north lies east of true north.
/// @throws InvalidInput where the place has no longitude and latitude.
[[nodiscard]] double meridian_convergence_deg(const std::string& wkt, const Vec2& at);
/// The name for people: 'EPSG:32633 (WGS 84 / UTM zone 33N)'; 'none' for an empty text.
[[nodiscard]] std::string crs_name(const std::string& wkt);
/// The WGS 84 / UTM zone of a place.
[[nodiscard]] std::string utm_crs(double lon_deg, double lat_deg);
/// WGS 84 longitude, latitude.
[[nodiscard]] std::string wgs84_crs();

/// Turns horizontal coordinates of one CRS into those of another. Not for use by several threads
/// at once.
class CrsTransform {
 public:
  /// @throws InvalidInput if there is no way from one to the other.
  CrsTransform(const std::string& from_wkt, const std::string& to_wkt);
  ~CrsTransform();
  CrsTransform(CrsTransform&&) noexcept;
  CrsTransform& operator=(CrsTransform&&) noexcept;

  /// @throws InvalidInput where a point has no counterpart.
  [[nodiscard]] Vec2 operator()(const Vec2& p) const;
  [[nodiscard]] std::vector<Vec2> operator()(const std::vector<Vec2>& points) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan

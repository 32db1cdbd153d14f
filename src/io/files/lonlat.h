#pragma once

#include <optional>
#include <vector>

#include "io/files/crs.h"

namespace swathplan {

/// Longitude and latitude (WGS84, degrees) of local positions and back, where the frame has a CRS.
class LonLat {
 public:
  explicit LonLat(Frame frame) : frame_(std::move(frame)) {
    if (frame_.crs_wkt.empty()) return;
    to_wgs84_.emplace(frame_.crs_wkt, wgs84_crs());
    from_wgs84_.emplace(wgs84_crs(), frame_.crs_wkt);
  }

  /// False where the input has no CRS: then the conversions must not be called.
  [[nodiscard]] bool known() const { return to_wgs84_.has_value(); }

  [[nodiscard]] std::vector<Vec2> from_local(std::vector<Vec2> points) const {
    for (Vec2& p : points) p = frame_.to_file(p);
    return (*to_wgs84_)(points);
  }
  [[nodiscard]] std::vector<Vec2> to_local(const std::vector<Vec2>& lonlat) const {
    std::vector<Vec2> points = (*from_wgs84_)(lonlat);
    for (Vec2& p : points) p = frame_.to_local(p);
    return points;
  }

 private:
  Frame frame_;
  std::optional<CrsTransform> to_wgs84_, from_wgs84_;
};

}  // namespace swathplan

#include "io/soundings/geographic_points.h"

#include <algorithm>
#include <cmath>

namespace swathplan {
namespace {

struct PlanExtent {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

PlanExtent plan_extent(const SurfaceData& points) {
  PlanExtent e{points.vertices.front().head<2>(), points.vertices.front().head<2>()};
  for (const Vec3& v : points.vertices) {
    e.low = e.low.cwiseMin(v.head<2>());
    e.high = e.high.cwiseMax(v.head<2>());
  }
  return e;
}

bool swap_axes(SurfaceData& points) {
  const PlanExtent e = plan_extent(points);
  const bool y_is_latitude = e.low.y() >= -90.0 && e.high.y() <= 90.0;
  const bool x_is_latitude = e.low.x() >= -90.0 && e.high.x() <= 90.0;
  if (y_is_latitude || !x_is_latitude || e.low.y() < -360.0 || e.high.y() > 360.0) return false;
  for (Vec3& v : points.vertices) std::swap(v.x(), v.y());
  for (auto& f : points.faces) std::swap(f[1], f[2]);
  points.notes.emplace_back(
      "the second coordinate goes beyond 90 degrees: it is the longitude, and the first one is the "
      "latitude");
  return true;
}

bool unwrap(SurfaceData& points) {
  const PlanExtent e = plan_extent(points);
  if (e.high.x() - e.low.x() <= 180.0 || e.low.x() < -180.0 || e.high.x() > 180.0) return false;
  double west = 180.0;   // the least longitude east of Greenwich
  double east = -180.0;  // the greatest one west of it
  for (const Vec3& v : points.vertices) {
    if (v.x() >= 0.0) {
      west = std::min(west, v.x());
    } else {
      east = std::max(east, v.x());
    }
  }
  if (east + 360.0 - west >= 180.0) return false;
  for (Vec3& v : points.vertices) {
    if (v.x() < 0.0) v.x() += 360.0;
  }
  points.notes.emplace_back(
      "the soundings lie on both sides of 180 degrees: longitudes west of it are counted on beyond "
      "180");
  return true;
}

}  // namespace

bool mend_geographic_points(SurfaceData& points) {
  if (points.vertices.empty()) return false;
  const bool swapped = swap_axes(points);
  return unwrap(points) || swapped;
}

}  // namespace swathplan

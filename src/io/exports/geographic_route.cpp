#include "io/exports/geographic_route.h"

#include <algorithm>
#include <cmath>

#include "coverage/route/thin_route.h"
#include "io/files/lonlat.h"
#include "mesh/base/error.h"
#include "mesh/plane/segments.h"

namespace swathplan {
namespace {

/// The share of the tolerance that the bend of segments may use; the rest is for thinning.
constexpr double kBendShare = 0.1;

/// The bend of each segment: how far its middle in longitude and latitude lies from the middle of
/// the straight line. The bend is even, so this is the largest distance.
std::vector<double> bends(const std::vector<Vec2>& local, const std::vector<Vec2>& lonlat,
                          const LonLat& conversion) {
  std::vector<Vec2> middles;
  for (std::size_t i = 1; i < lonlat.size(); ++i) {
    Vec2 step = lonlat[i] - lonlat[i - 1];
    step.x() = std::remainder(step.x(), 360.0);  // over the antimeridian
    middles.emplace_back(lonlat[i - 1] + 0.5 * step);
  }
  middles = conversion.to_local(middles);
  std::vector<double> result;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const Vec2 along = local[i + 1] - local[i];
    const Vec2 off = middles[i] - local[i];
    const double length = along.norm();
    result.push_back(length > 0.0 ? std::abs(cross(along, off)) / length : off.norm());
  }
  return result;
}

/// Cuts each segment into equal parts that bend no more than `most_m`. A part of 1/n of the length
/// bends by 1/n^2.
Route divided(const Route& route, const std::vector<double>& bend, double most_m) {
  Route result;
  const auto& w = route.waypoints;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(bend[i] / most_m))));
    for (int k = 0; k < parts; ++k) {
      result.waypoints.push_back(w[i]);
      result.waypoints.back().position += (w[i + 1].position - w[i].position) * k / parts;
    }
  }
  result.waypoints.push_back(w.back());
  return result;
}

}  // namespace

GeographicRoute geographic_route(const Route& route, const Frame& frame, double tolerance_m,
                                 const AreaQuery* water) {
  const LonLat conversion(frame);
  if (!conversion.known()) {
    throw InvalidInput("the route has no coordinate reference system: give it with <CRS> EPSG:n");
  }
  const ThinnedRoute thinned = thin_route(route, (1.0 - kBendShare) * tolerance_m, water);
  std::vector<Vec2> local = positions(thinned.route.waypoints);
  const std::vector<double> bend = bends(local, conversion.from_local(local), conversion);
  // Half the share: the curve is only nearly a parabola, so the bends of its parts differ a little.
  GeographicRoute result{divided(thinned.route, bend, 0.5 * kBendShare * tolerance_m), {}, 0.0};
  local = positions(result.route.waypoints);
  result.lonlat = conversion.from_local(local);
  const std::vector<double> left = bends(local, result.lonlat, conversion);
  const auto most = std::max_element(left.begin(), left.end());
  result.largest_distance_m = thinned.largest_distance_m + (most == left.end() ? 0.0 : *most);
  return result;
}

}  // namespace swathplan

#include "planners/job/ground_slope.h"

namespace swathplan {

std::optional<Vec2> depth_gradient(const DepthQuery& depths, const Vec2& p, double span_m) {
  const double half = 0.5 * span_m;
  const auto west = depths.depth(p - Vec2(half, 0));
  const auto east = depths.depth(p + Vec2(half, 0));
  const auto south = depths.depth(p - Vec2(0, half));
  const auto north = depths.depth(p + Vec2(0, half));
  if (!west || !east || !south || !north) return std::nullopt;
  return Vec2((*east - *west) / span_m, (*north - *south) / span_m);
}

}  // namespace swathplan

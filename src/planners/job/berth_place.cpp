#include "planners/job/berth_place.h"

#include "mesh/plane/area_query.h"

namespace swathplan {
namespace {

/// Where an edge of the water runs at a slant, its safe part lies farther off than the clearance.
constexpr double kSlant = 2.0;
/// Places are taken so far inside the safe water, metres, so that rounding leaves them there.
constexpr double kInside = 0.1;

/// The place of the water nearest to p, a little inside it.
Vec2 nearest_inside(const Vec2& p, const AreaQuery& water) {
  Vec2 edge = water.nearest_on_outline(p);
  const Vec2 way = edge - p;
  if (!(way.norm() > 0.0)) return edge;
  Vec2 inside = edge + kInside * way.normalized();
  return water.contains(inside) ? inside : edge;
}

}  // namespace

BerthPlace berth_place(const Vec2& berth, const Ground& ground, const Vehicle& vehicle) {
  const AreaQuery water(ground.water);
  if (water.contains(berth)) return {BerthPlace::Lies::in_safe_water, berth, 0.0};
  BerthPlace found;
  found.place = nearest_inside(berth, water);
  found.apart_m = (found.place - berth).norm();
  const auto depth = ground.depths->depth(berth);
  const bool deep = depth && *depth >= safe_depth_m(vehicle);
  if (deep && found.apart_m <= kSlant * vehicle.clearance_m + kInside) {
    found.lies = BerthPlace::Lies::beside_it;
  }
  return found;
}

}  // namespace swathplan

#pragma once

#include "planners/plan.h"

namespace swathplan {

/// Where a boat can begin from a berth.
struct BerthPlace {
  enum class Lies {
    in_safe_water,
    beside_it,  ///< in water that is deep enough, nearer to a wall than the clearance
    off_it      ///< on land, beyond the data, in water too shoal, or in a no-go area
  };
  Lies lies = Lies::off_it;
  Vec2 place = Vec2::Zero();  ///< the berth itself, or the nearest place in safe water
  double apart_m = 0.0;       ///< between the two
};

/// Looks a berth up. One beside the safe water lies no farther from it than the clearance asks.
[[nodiscard]] BerthPlace berth_place(const Vec2& berth, const Ground& ground,
                                     const Vehicle& vehicle);

}  // namespace swathplan

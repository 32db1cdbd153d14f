#pragma once

#include <map>
#include <vector>

#include "planners/steering/safe_water.h"

namespace swathplan {

/// Metres through the water from one place to all others, by a raster whose neighbours see each
/// other. Walls count however thin they are. Ways over eight neighbours are up to 8 % too long.
class WaterDistances {
 public:
  /// `water` must outlive it.
  explicit WaterDistances(const SafeWater& water);

  /// Metres from each cell of the raster to `goal`; infinite where no way leads. Kept, so that a
  /// goal asked for again costs nothing. O(cells) the first time.
  [[nodiscard]] const std::vector<float>& to(const Vec2& goal);
  /// Metres from p by the distances of `to(goal)`; infinite where p sees no cell.
  [[nodiscard]] double from(const Vec2& p, const std::vector<float>& distances) const;

 private:
  void link();
  /// Calls visit(cell, metres from p) for the four cells about p that p sees.
  template <class Visit>
  void each_seen(const Vec2& p, Visit visit) const;

  const SafeWater& water_;
  std::vector<unsigned char> links_;  ///< of each cell, a bit for each neighbour that it sees
  std::map<std::size_t, std::vector<float>> known_;
  std::vector<Vec2> goals_;
};

}  // namespace swathplan

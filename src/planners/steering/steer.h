#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "planners/steering/connect.h"

namespace swathplan {

/// A point of a steered line; what holds at point `source` of the line as given holds here.
struct SteeredPoint {
  Vec2 position = Vec2::Zero();
  std::size_t source = 0;
  bool tight = false;  ///< a turn tighter than the radius that no way was found around
};

/// What became of a line's tight turns.
struct Steering {
  std::vector<SteeredPoint> points;
  std::size_t mended = 0;  ///< tight turns that were replaced
  std::size_t loops = 0;   ///< of them, by a way that is longer by more than half a circle
  std::size_t left = 0;    ///< stretches left tight
  double added_m = 0.0;  ///< what mending added to the length (less than 0: it was the shorter way)
};

/// Replaces each stretch of a line that turns tighter than `radius_m` by a Dubins path from a place
/// before it to a place behind it that stays in the water and that `allowed` accepts (empty: all),
/// so that the whole line is kept but there: of the places within kReach radii, those that cost the
/// least extra length and the least of the line. A line without tight turns comes back as it is.
[[nodiscard]] Steering steered(const std::vector<Vec2>& line, double radius_m,
                               const Connector& connector,
                               const std::function<bool(const std::vector<Vec2>&)>& allowed = {});

}  // namespace swathplan

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "planners/steering/connect.h"

namespace swathplan {

/// A point of a steered line. It has the properties of point `source` of the given line.
struct SteeredPoint {
  Vec2 position = Vec2::Zero();
  std::size_t source = 0;
  bool tight = false;  ///< a turn tighter than the radius that could not be replaced
};

/// A line after its tight turns were replaced.
struct Steering {
  std::vector<SteeredPoint> points;
  std::size_t mended = 0;  ///< tight turns that were replaced
  std::size_t loops = 0;   ///< of them: paths longer by more than half a circle
  std::size_t left = 0;    ///< tight turns that stay
  double added_m = 0.0;    ///< length added; below 0 where the new path is shorter
};

/// Replaces each stretch of a line that turns tighter than `radius_m` by a Dubins path. The path
/// begins at a place before the stretch and ends at one behind it, both within kReach radii. It
/// stays in the water, and `allowed` accepts it (empty: every path). Of all such paths the cheapest
/// is taken, by its extra length and the length of line that it replaces. The rest of the line is
/// kept. A line without tight turns comes back unchanged.
[[nodiscard]] Steering steered(const std::vector<Vec2>& line, double radius_m,
                               const Connector& connector,
                               const std::function<bool(const std::vector<Vec2>&)>& allowed = {});

}  // namespace swathplan

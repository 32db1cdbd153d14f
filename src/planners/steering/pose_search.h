#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesh/base/angle.h"
#include "mesh/plane/polygons.h"
#include "planners/steering/dubins.h"

namespace swathplan {

/// Limits of a search over poses, and its questions about the water.
struct PoseSearchOptions {
  double radius_m = 1.5;  ///< smallest turn radius, > 0
  int most_poses = 150000;
  /// Whether a place lies in the water. The search first asks this at a few places of a path.
  std::function<bool(const Vec2&)> place_in_water;
  /// Whether a path of points stays in the water.
  std::function<bool(const std::vector<Vec2>&)> in_water;
  /// Metres around a place that are water for certain, or 0. Empty: nothing is known. It only saves
  /// questions of the other two kinds.
  std::function<double(const Vec2&)> clear_around;
  /// Told of each search how many poses it took. May be empty.
  std::function<void(int)> searched;
};

/// A forward path from one pose to another, given as poses that Dubins paths in the water join.
/// Method: A* over a lattice of places and courses, whose steps are straights and arcs of the
/// radius to either side. From time to time a Dubins path to the goal is tried. At the end the path
/// is pulled taut. `to_go(p)` estimates the metres from p to the goal, best as a lower bound.
/// Deterministic. Empty: no path was found within `most_poses` poses.
[[nodiscard]] std::optional<std::vector<Pose>> search_poses(
    const Pose& from, const Pose& to, const std::function<double(const Vec2&)>& to_go,
    const PoseSearchOptions& options);

/// The shortest Dubins path between two poses that stays in the water.
[[nodiscard]] std::optional<DubinsPath> dubins_in_water(const Pose& from, const Pose& to,
                                                        const PoseSearchOptions& options);

/// Whether a Dubins path stays in the water.
[[nodiscard]] bool stays_in_water(const DubinsPath& path, const PoseSearchOptions& options);

/// Spacing of the points that a curve of this radius is written with, metres.
[[nodiscard]] double curve_step_m(double radius_m);

}  // namespace swathplan

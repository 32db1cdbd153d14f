#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// Weights are per point and dimensionless: lengths are divided by the step.
struct SmoothOptions {
  double radius_m = 1.5;     ///< smallest turn radius, > 0
  double width_m = 25.6;     ///< W, the footprint width
  double step_m = 1.6;       ///< spacing of the points that are moved, > 0
  double deviation_m = 2.0;  ///< no point moves farther than this, >= 0
  double curvature_weight = 1.0;
  double deviation_weight = 0.02;
  double spacing_weight = 0.02;
  std::size_t window = 160;  ///< points solved at once
  std::size_t overlap = 30;  ///< of them solved again with the next window
  /// Metres from a segment to what the path must not cross (the water's edge, blocked edges); no
  /// point moves farther than that. Empty: open water.
  std::function<double(const Vec2&, const Vec2&)> room = {};
  /// Where points are wanted, given where they are and how many metres along the skeleton they come
  /// from. Asked `pull_rounds` times: after each round but the last the path is relaxed towards the
  /// answer without the constraints, after the last Ipopt solves the problem near the answer.
  /// Empty: the skeleton's own points.
  std::function<std::vector<Vec2>(const std::vector<Vec2>&, const std::vector<double>&)> pull = {};
  int pull_rounds = 8;
};

struct SmoothResult {
  std::vector<Vec2> points;    ///< begins and ends where the skeleton does
  std::vector<double> along;   ///< metres along the skeleton that each point came from
  std::vector<char> smoothed;  ///< 0: in a window that failed; the skeleton's own point
  std::size_t windows = 0, failed_windows = 0;
  std::map<std::string, std::size_t> status;  ///< Ipopt's verdict -> windows
  double failed_m = 0.0;                      ///< of the skeleton that was kept as it is
};

/// Moves the points of a path, sampled at an even step, to where its curvature changes least, near
/// the skeleton and where `pull` wants them: docs/smoothing.md states the problem.
/// Solved by Ipopt in overlapping windows, one after another: O(length). Guarantees: (1) both ends
/// stay; (2) no point moves farther than `deviation_m`, nor than its segments' room, nor half-way
/// to the next pass, so nothing is crossed that the skeleton does not cross; (3) a window that
/// Ipopt does not solve keeps the skeleton and is counted. Points of a skeleton that coincide are
/// dropped; a path shorter than four steps comes back as it is. Deterministic.
/// @throws UsageError for an option out of its range.
[[nodiscard]] SmoothResult smooth_path(const std::vector<Vec2>& skeleton,
                                       const SmoothOptions& options);

/// The path with each corner replaced by the arc that touches both of its segments and begins in
/// the middle of the shorter one, in chords of `step_deg` at most: its radius is what
/// RouteFigures::min_turn_radius_m says of the corner. `source[i]`: the corner that point i is of.
struct ArcPath {
  std::vector<Vec2> points;
  std::vector<std::size_t> source;
};
[[nodiscard]] ArcPath with_arcs(const std::vector<Vec2>& path, double step_deg = 3.0);

}  // namespace swathplan

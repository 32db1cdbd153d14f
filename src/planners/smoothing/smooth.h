#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mesh/base/frame.h"
#include "mesh/base/watch.h"

namespace swathplan {

/// Weights are per point, without a unit: lengths are divided by the step.
struct SmoothOptions {
  double radius_m = 1.5;     ///< smallest turn radius, > 0
  double step_m = 1.6;       ///< spacing of the points that are moved, > 0
  double deviation_m = 2.0;  ///< no point moves farther than this, >= 0
  double curvature_weight = 1.0;
  double deviation_weight = 0.02;
  std::size_t window = 160;  ///< points that are solved together
  std::size_t overlap = 30;  ///< of them, points that the next window solves again
  /// Metres from a segment to what the path must not cross: the water's edge and blocked edges. No
  /// point moves farther than that. Empty: open water.
  std::function<double(const Vec2&, const Vec2&)> room = {};
  /// Where points should move to. It is told where they are, and how many metres along the skeleton
  /// they come from. It is asked `pull_rounds` times. After each round but the last, the path is
  /// relaxed towards the answer without the constraints. After the last one, Ipopt solves the
  /// problem near the answer. Empty: points stay near the skeleton's own.
  std::function<std::vector<Vec2>(const std::vector<Vec2>&, const std::vector<double>&)> pull = {};
  int pull_rounds = 8;
  Watch watch = {};  ///< if it ends the work, windows that are not solved yet keep the skeleton
};

struct SmoothResult {
  std::vector<Vec2> points;    ///< begins and ends where the skeleton does
  std::vector<double> along;   ///< metres along the skeleton that each point came from
  std::vector<char> smoothed;  ///< 0: the skeleton's own point, kept since its window failed
  std::size_t windows = 0, failed_windows = 0;
  std::map<std::string, std::size_t> status;  ///< Ipopt's verdict -> windows
  double failed_m = 0.0;                      ///< of the skeleton that was kept as it is
};

/// Smooths a path. Its points, at an even step, move to where the curvature changes least. They
/// stay near the skeleton, or near where `pull` wants them; docs/smoothing.md states the problem.
/// Ipopt solves it in overlapping windows, one after another: O(length). Guarantees: (1) both ends
/// stay; (2) no point moves farther than `deviation_m`, than its segments' room, or half-way to the
/// next pass, so the path crosses nothing that the skeleton does not cross; (3) a window that Ipopt
/// does not solve keeps the skeleton and is counted. Points of a skeleton that coincide are
/// dropped. A path shorter than four steps comes back unchanged. Deterministic.
/// @throws UsageError for an option out of its range.
[[nodiscard]] SmoothResult smooth_path(const std::vector<Vec2>& skeleton,
                                       const SmoothOptions& options);

/// The path with each corner replaced by an arc. The arc touches both segments of the corner and
/// begins in the middle of the shorter one. So its radius is the bend_radius_m of
/// the corner. Its chords turn by at most `step_deg`. `source[i]`: the corner that point i belongs
/// to.
struct ArcPath {
  std::vector<Vec2> points;
  std::vector<std::size_t> source;
};
[[nodiscard]] ArcPath with_arcs(const std::vector<Vec2>& path, double step_deg = 3.0);

}  // namespace swathplan

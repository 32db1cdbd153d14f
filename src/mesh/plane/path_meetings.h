#pragma once

#include <cstddef>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// Places where a path meets itself, as a person sees them on a map: parts that are nearer to each
/// other than kTogetherM are together.
struct PathMeetings {
  /// Places where the path arrives on one side of itself and leaves on the other. Many segments may
  /// meet there, and the path may run along itself in between: that is one crossing.
  std::size_t crossings = 0;
  /// Places where the path runs along an earlier stretch of itself for at least kSharedM, in either
  /// direction. Whether it also crosses there does not matter.
  std::size_t shared_stretches = 0;
  double shared_m = 0.0;  ///< metres sailed along earlier stretches; each metre counts once
};

/// Waypoints are written to the millimetre or finer, so a stretch that is sailed twice differs by
/// less than this.
inline constexpr double kTogetherM = 0.005;
/// A shorter stretch along the path itself is no shared stretch.
inline constexpr double kSharedM = 1.0;

/// Where the path meets itself. Guarantees: (1) a touch is no crossing; (2) a turn straight back is
/// none, nor is a meeting in which the path begins or ends; (3) a path sailed backwards gives the
/// same, but for the rounding of shared_m. Detours of less than kTogetherM are not seen. Nothing
/// for a path of fewer than four points. About O(n log n) for paths that spread over the plane.
[[nodiscard]] PathMeetings path_meetings(const std::vector<Vec2>& path);

}  // namespace swathplan

#pragma once

#include <cstddef>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// Places where a path meets itself, as people see them: what is nearer than kTogetherM is
/// together.
struct PathMeetings {
  /// Places where the path comes in on one side of itself and leaves on the other, however many
  /// segments meet there and however far it runs along itself between.
  std::size_t crossings = 0;
  /// Places where the path runs along an earlier stretch of itself for at least kSharedM, either
  /// way round, whether it crosses there or not.
  std::size_t shared_stretches = 0;
  double shared_m = 0.0;  ///< metres sailed along earlier stretches; no metre counts twice
};

/// Waypoints are written in millimetres or better, so that a stretch that is sailed twice differs
/// by less than this.
inline constexpr double kTogetherM = 0.005;
inline constexpr double kSharedM = 1.0;

/// Guarantees: (1) a touch is no crossing; (2) neither is a turn back on itself, or a meeting in
/// which the path begins or ends; (3) the same for the path sailed backwards, but for shared_m by
/// rounding. Detours from a stretch by less than kTogetherM are not seen.
/// About O(n log n) for paths that spread over the plane.
[[nodiscard]] PathMeetings path_meetings(const std::vector<Vec2>& path);

}  // namespace swathplan

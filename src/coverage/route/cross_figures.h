#pragma once

#include <cstddef>

#include "coverage/route/route.h"

namespace swathplan {

/// What a route's cross-lines are worth as a check of its main scheme. The main scheme is what is
/// logged of kinds `line` and `infill`; cross-lines are what is logged of kind `cross`.
struct CrossFigures {
  std::size_t lines = 0;         ///< legs
  double length_m = 0.0;         ///< of cross-lines
  double main_length_m = 0.0;    ///< of the main scheme
  std::size_t crossings = 0;     ///< places where a cross-line crosses a line of the main scheme
  std::size_t right_angled = 0;  ///< of them, within kRightAngleDeg of 90 degrees
  /// Length of cross-lines / length of the main scheme; 0 without a main scheme.
  [[nodiscard]] double share() const {
    return main_length_m > 0.0 ? length_m / main_length_m : 0.0;
  }
};
inline constexpr double kRightAngleDeg = 20.0;

/// O(segments of cross-lines x segments of the main scheme).
[[nodiscard]] CrossFigures cross_figures(const Route& route);

/// The angle between two ways, whichever way they are sailed, [0, 90] degrees.
[[nodiscard]] double crossing_angle_deg(const Vec2& a, const Vec2& b);

}  // namespace swathplan

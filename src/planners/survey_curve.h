#pragma once

#include <vector>

#include "coverage/route.h"

namespace swathplan {

/// A survey line of any shape, sailed either way: points no farther apart than kCurveStep.
struct SurveyCurve {
  std::vector<Vec2> points;
};

/// Fans are set and curves are drawn at this step, metres.
inline constexpr double kCurveStep = 1.0;

[[nodiscard]] double length_m(const SurveyCurve& curve);
/// The same curve with points each `step_m` or a little less, ends kept.
[[nodiscard]] SurveyCurve resampled(const SurveyCurve& curve, double step_m);
/// The straight curve from a to b.
[[nodiscard]] SurveyCurve straight_curve(const Vec2& a, const Vec2& b);

}  // namespace swathplan

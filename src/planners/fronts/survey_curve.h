#pragma once

#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

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

/// The curve after so many passes of a binomial filter over its points; ends kept.
[[nodiscard]] SurveyCurve smoothed(SurveyCurve curve, int passes);
/// Catmull-Rom through the points, in `parts` chords between two of them.
[[nodiscard]] SurveyCurve splined(const SurveyCurve& curve, int parts);
/// The maximal parts of the curve inside the area.
[[nodiscard]] std::vector<SurveyCurve> cut_to(const SurveyCurve& curve, const AreaQuery& area);
/// True where the curve ends where it begins.
[[nodiscard]] bool is_closed(const SurveyCurve& curve);

}  // namespace swathplan

#pragma once

#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// A survey line of any shape, which may be sailed either way. Its points lie no farther apart than
/// kCurveStep.
struct SurveyCurve {
  std::vector<Vec2> points;
};

/// Fans are set and curves are drawn at this step, metres.
inline constexpr double kCurveStep = 1.0;

[[nodiscard]] double length_m(const SurveyCurve& curve);
/// The same curve with points `step_m` or a little less apart. Both ends stay.
[[nodiscard]] SurveyCurve resampled(const SurveyCurve& curve, double step_m);
/// The straight curve from a to b.
[[nodiscard]] SurveyCurve straight_curve(const Vec2& a, const Vec2& b);

/// The curve after `passes` passes of a binomial filter over its points. Both ends stay.
[[nodiscard]] SurveyCurve smoothed(SurveyCurve curve, int passes);
/// A Catmull-Rom spline through the points, with `parts` chords between two of them.
[[nodiscard]] SurveyCurve splined(const SurveyCurve& curve, int parts);
/// The maximal parts of the curve inside the area.
[[nodiscard]] std::vector<SurveyCurve> cut_to(const SurveyCurve& curve, const AreaQuery& area);
/// True where the curve ends where it begins.
[[nodiscard]] bool is_closed(const SurveyCurve& curve);

}  // namespace swathplan

#include "planners/survey_curve.h"

#include <algorithm>
#include <cmath>

namespace swathplan {

double length_m(const SurveyCurve& curve) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    length += (curve.points[i + 1] - curve.points[i]).norm();
  }
  return length;
}

SurveyCurve resampled(const SurveyCurve& curve, double step_m) {
  const double length = length_m(curve);
  if (curve.points.size() < 2 || !(length > 0.0)) return curve;
  const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(length / step_m)));
  SurveyCurve result;
  result.points.reserve(parts + 1);
  std::size_t segment = 0;
  double before = 0.0;
  double here = (curve.points[1] - curve.points[0]).norm();
  for (std::size_t k = 0; k < parts; ++k) {
    const double s = length * static_cast<double>(k) / static_cast<double>(parts);
    while (segment + 2 < curve.points.size() && s > before + here) {
      before += here;
      ++segment;
      here = (curve.points[segment + 1] - curve.points[segment]).norm();
    }
    const double t = here > 0.0 ? std::clamp((s - before) / here, 0.0, 1.0) : 0.0;
    result.points.push_back((1.0 - t) * curve.points[segment] + t * curve.points[segment + 1]);
  }
  result.points.push_back(curve.points.back());
  return result;
}

SurveyCurve straight_curve(const Vec2& a, const Vec2& b) { return resampled({{a, b}}, kCurveStep); }

}  // namespace swathplan

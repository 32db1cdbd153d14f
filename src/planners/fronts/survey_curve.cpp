#include "planners/fronts/survey_curve.h"

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

SurveyCurve smoothed(SurveyCurve curve, int passes) {
  auto& p = curve.points;
  for (int pass = 0; pass < passes && p.size() > 2; ++pass) {
    Vec2 before = p[0];
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      const Vec2 here = p[i];
      p[i] = 0.25 * before + 0.5 * here + 0.25 * p[i + 1];
      before = here;
    }
  }
  return curve;
}

SurveyCurve splined(const SurveyCurve& curve, int parts) {
  const auto& p = curve.points;
  if (p.size() < 3) return resampled(curve, kCurveStep / parts);
  SurveyCurve result;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const Vec2& a = p[i > 0 ? i - 1 : 0];
    const Vec2& d = p[std::min(i + 2, p.size() - 1)];
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      result.points.push_back(0.5 * (2.0 * p[i] + t * (p[i + 1] - a) +
                                     t * t * (2.0 * a - 5.0 * p[i] + 4.0 * p[i + 1] - d) +
                                     t * t * t * (3.0 * p[i] - a - 3.0 * p[i + 1] + d)));
    }
  }
  result.points.push_back(p.back());
  return result;
}

std::vector<SurveyCurve> cut_to(const SurveyCurve& curve, const AreaQuery& area) {
  constexpr double kWhole = 1e-9;  // parameters of a segment this near to 0 or 1 are its ends
  std::vector<SurveyCurve> parts;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Vec2& a = curve.points[i];
    const Vec2& b = curve.points[i + 1];
    bool reaches_end = false;
    for (const auto& [t0, t1] : area.clip(a, b)) {
      if (!(goes_on && t0 < kWhole)) parts.push_back({{a + t0 * (b - a)}});
      parts.back().points.push_back(a + t1 * (b - a));
      reaches_end = t1 > 1.0 - kWhole;
    }
    goes_on = reaches_end;
  }
  return parts;
}

bool is_closed(const SurveyCurve& curve) {
  return curve.points.size() > 3 && curve.points.front() == curve.points.back();
}

}  // namespace swathplan

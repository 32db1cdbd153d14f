#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swathplan {

/// P(y): the probability that a target at lateral range y is detected. It is linear between the
/// points, and 0 outside them (no data).
struct DetectionCurve {
  std::vector<double> range_m;  ///< ascending, >= 0
  std::vector<double> p;        ///< same size, each in [0, 1]
};
/// @throws InvalidInput if the curve is empty, unsorted, has a NaN, a probability outside [0, 1] or
/// lists of different lengths; `what` names the curve.
void check(const DetectionCurve& curve, const std::string& what);

[[nodiscard]] double detection(const DetectionCurve& curve, double range_m);

/// The range up to which data is good: the far end of the stretch around the curve's peak where P
/// is at least `threshold`. Empty if the peak lies below the threshold.
/// @throws InvalidInput as check(), UsageError if the threshold lies outside (0, 1).
[[nodiscard]] std::optional<double> admissible_range_m(const DetectionCurve& curve,
                                                       double threshold);

/// Trials and detections of one track per range bin, both sides together: how many targets were
/// there, and how many were found.
struct DetectionCounts {
  double first_m = 0.0, step_m = 5.0;  ///< bin i spans first + i step to first + (i + 1) step
  std::vector<std::int64_t> trials, detections;
};
/// Estimates the curve from counts. Its points are detections / trials at the bins' centres,
/// changed as little as possible (least squares, weighted by the trials) so that the curve rises to
/// one peak and falls after it. The outermost bins with a detection reach to their outer edges.
/// Bins without trials are left out.
/// @throws InvalidInput for lists of different lengths, negative counts, more detections than
/// trials, a step that is not positive, or no trial at all.
[[nodiscard]] DetectionCurve estimated_curve(const DetectionCounts& counts);

/// A curve like the one published for a synthetic aperture sonar: nothing below 40 m, best near
/// 70 m, 0.05 at 130 m and nothing beyond.
[[nodiscard]] DetectionCurve example_curve();

}  // namespace swathplan

#pragma once

#include <memory>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// The smoothing problem's curvature and deviation terms without its constraints: a banded linear
/// system, factored once, that takes a thousandth of what Ipopt takes. Ends stay.
class PathRelaxation {
 public:
  /// Weights as in SmoothOptions, of a path of `points` points (at least four).
  PathRelaxation(std::size_t points, double curvature_weight, double deviation_weight);
  ~PathRelaxation();

  /// The path near `wanted` whose curvature changes least, clamped to boxes of half-side `room`
  /// around `middle`.
  [[nodiscard]] std::vector<Vec2> relaxed(const std::vector<Vec2>& wanted,
                                          const std::vector<Vec2>& middle,
                                          const std::vector<double>& room) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan

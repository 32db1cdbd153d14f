#pragma once

#include <memory>
#include <vector>

#include "mesh/base/frame.h"

namespace swathplan {

/// Solves the smoothing problem without its constraints: only the curvature and deviation terms are
/// left. They make a banded linear system, which is factored once. A solution takes a thousandth of
/// Ipopt's time. Both ends stay.
class PathRelaxation {
 public:
  /// `points`: number of points of the path, at least four. Weights are as in SmoothOptions.
  PathRelaxation(std::size_t points, double curvature_weight, double deviation_weight);
  ~PathRelaxation();

  /// The path near `wanted` whose curvature changes least. Each point is then clamped to a box of
  /// half-side `room` around `middle`.
  [[nodiscard]] std::vector<Vec2> relaxed(const std::vector<Vec2>& wanted,
                                          const std::vector<Vec2>& middle,
                                          const std::vector<double>& room) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace swathplan

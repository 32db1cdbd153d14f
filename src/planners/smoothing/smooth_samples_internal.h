#pragma once

#include <cstddef>
#include <vector>

#include "planners/smoothing/smooth.h"
#include "planners/steering/line_poses.h"

namespace swathplan {

/// Points at even steps along the skeleton.
struct Samples {
  std::vector<Vec2> points;
  std::vector<double> along;
  double step = 0.0;
};
[[nodiscard]] Samples sampled(const LinePoses& line, double step);

/// How far each point may move: box half-sides.
[[nodiscard]] std::vector<double> rooms(const Samples& s, const SmoothOptions& o);

}  // namespace swathplan

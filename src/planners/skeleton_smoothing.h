#pragma once

#include <utility>
#include <vector>

#include "planners/nuc.h"
#include "planners/smooth.h"

namespace swathplan {

/// The smoothing that suits a plan: steps of W/16, points moved by at most W/12.
[[nodiscard]] SmoothOptions smoothing_for(const PlanOptions& options);

/// A skeleton's path (opened, its first point first) smoothed, corners as arcs; each point has the
/// face of the skeleton point that it came from. `blocked`: segments that it must not cross,
/// besides the edge of the water. What Ipopt said is added to `verdict`.
[[nodiscard]] std::vector<SkeletonPoint> smoothed(const SkeletonCycle& cycle,
                                                  const std::vector<std::pair<Vec2, Vec2>>& blocked,
                                                  const Area& water, const SmoothOptions& options,
                                                  SmoothResult& verdict);

}  // namespace swathplan

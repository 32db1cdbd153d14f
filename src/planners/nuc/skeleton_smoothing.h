#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "planners/nuc/nuc.h"
#include "planners/nuc/thin_cover.h"
#include "planners/smoothing/smooth.h"

namespace swathplan {

/// The smoothing that suits a plan: steps of W/16, points moved by at most kSmoothReach W.
[[nodiscard]] SmoothOptions smoothing_for(const PlanOptions& options);
inline constexpr double kSmoothReach = 0.16;

/// What the path covers, and the fan over each face of the skeleton's mesh.
struct FannedCover {
  const ThinCover& cover;
  std::function<FanAngles(std::uint32_t face)> fan_of;
};

/// A skeleton's path (opened, its first point first) smoothed, corners as arcs; each point has the
/// face of the skeleton point that it came from. `blocked`: segments that it must not cross,
/// besides the edge of the water. With `cover` its points are pulled to where they leave less of
/// the area empty. What Ipopt said is added to `verdict`.
[[nodiscard]] std::vector<SkeletonPoint> smoothed(const SkeletonCycle& cycle,
                                                  const std::vector<std::pair<Vec2, Vec2>>& blocked,
                                                  const Area& water, const SmoothOptions& options,
                                                  SmoothResult& verdict,
                                                  const FannedCover* cover = nullptr);

}  // namespace swathplan

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

/// Smooths the path of an opened skeleton; corners become arcs. Each point has the face of the
/// skeleton point that it came from. The path crosses neither the edge of the water nor the
/// segments `blocked`. With `cover` its points are pulled to where they leave less of the area
/// empty. The counts of Ipopt's verdicts are added to `verdict`.
[[nodiscard]] std::vector<SkeletonPoint> smoothed(const SkeletonCycle& cycle,
                                                  const std::vector<std::pair<Vec2, Vec2>>& blocked,
                                                  const Area& water, const SmoothOptions& options,
                                                  SmoothResult& verdict,
                                                  const FannedCover* cover = nullptr);

}  // namespace swathplan

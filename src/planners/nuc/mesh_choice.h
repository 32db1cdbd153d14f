#pragma once

#include <functional>

#include "planners/plan.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// In an area of few faces, the place of their lattice changes the coverage by several points. So
/// plans are made on several lattices, turned against the area's main direction and finer. Each
/// plan is scored. The one with the best coverage, less a price (kMissedPerRatio) for its length
/// ratio, is kept, and a note names it. The plain mesh is taken if it has more than kFewFaces
/// faces, if the face size is given, or if there is no scene. `plan_on` makes the plan on a mesh,
/// with the connector of all of them. Deterministic; equal scores keep the earlier candidate.
[[nodiscard]] Plan best_mesh_plan(const Ground& ground, const PlanOptions& options,
                                  const std::function<Plan(PlanarMesh, const Connector&)>& plan_on);

inline constexpr std::size_t kFewFaces = 100;
/// One more ideal length must bring this share of the coverage that a good candidate (the lower
/// quartile) misses. It is a share because dense pings miss less, and are worth finer faces too.
inline constexpr double kMissedPerRatio = 0.68;

}  // namespace swathplan

#pragma once

#include <functional>

#include "planners/plan.h"

namespace swathplan {

/// Where the survey area holds few faces, where their lattice happens to fall decides over several
/// points of coverage. So, unless the face size is given, several lattices (turned against the
/// area's main direction, and finer) are planned on, each plan is scored, and the one with the best
/// coverage less a price (kMissedPerRatio) for its length ratio is kept; a note says which. With
/// more than kFewFaces faces, a given face size, or no scene, the plain mesh is taken. `plan_on`
/// makes the plan on a mesh. Deterministic; equal scores keep the earlier candidate.
[[nodiscard]] Plan best_mesh_plan(const PlanningGround& ground, const PlanOptions& options,
                                  const std::function<Plan(PlanarMesh)>& plan_on);

inline constexpr std::size_t kFewFaces = 100;
/// Share of what a good candidate (lower quartile) misses that one more ideal length must bring: a
/// share, so that dense pings, which miss less, are worth finer faces too.
inline constexpr double kMissedPerRatio = 0.68;

}  // namespace swathplan

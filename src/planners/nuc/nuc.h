#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planners/plan.h"

namespace swathplan {

/// A point of a NUC skeleton: the centroid of a sub-facet, or, where the straight way between two
/// sub-facets would miss their shared half-edge, a point of that edge.
struct SkeletonPoint {
  Vec2 position = Vec2::Zero();
  std::uint32_t face = 0;
  std::uint16_t corner = 0;  ///< the sub-facet is the quad at this corner of the face
  bool sub_facet = true;     ///< false for a point on an edge
  float ahead_m = 0.0F;      ///< of the way to the next point, what lies in this face
  float behind_m = 0.0F;     ///< of the way from the point before, what lies in this face
};

/// A closed path through every sub-facet of one connected part of a mesh.
using SkeletonCycle = std::vector<SkeletonPoint>;

/// Non-revisiting uniform coverage: each n-gon facet is cut into n quads (corner, two edge
/// midpoints, barycentre) whose centroids form a cycle; along a spanning tree of the facets a
/// child's cycle is spliced into its parent's between the two quads that touch their shared edge.
/// `open[i]`: whether the path may cross shared edge i; empty: all.
/// Guarantees, for convex faces: (1) every sub-facet is visited once; (2) no cycle crosses itself;
/// (3) no edge that is not open is crossed, a tree edge is crossed once in and once out; (4) one
/// cycle per part that open edges connect, in the order of their lowest face.
/// Degenerate: a single face gives its own cycle; an empty mesh none. Cost: O(n) time and memory
/// (linked splice).
/// Method: [yang-nuc], [larrazabal-mdnuc] section III.A.
[[nodiscard]] std::vector<SkeletonCycle> nuc_skeleton(const PlanarMesh& mesh,
                                                      const std::vector<SharedEdge>& edges,
                                                      const std::vector<char>& open = {});

/// NUC on the whole survey area with one opening angle from its mean depth.
[[nodiscard]] Plan plan_nuc(const PlanningGround& ground, const PlanOptions& options);

/// The path along skeleton points `p` with each corner rounded by an arc that touches the ways to
/// and from it, at most half-way and never outside the corner's own face: so it crosses no edge
/// that the skeleton does not cross, nor itself. Arcs are drawn in chords of at most
/// `kArcStepDeg` degrees. A fan that turns through a corner sweeps its outside, a jump in course
/// leaves it empty; and the arc is the shorter way. An arc is as wide as `radius_m` where that
/// fits.
[[nodiscard]] std::vector<SkeletonPoint> rounded(const std::vector<SkeletonPoint>& p,
                                                 double radius_m = 0.0);
inline constexpr double kArcStepDeg = 3.0;

/// Skeleton cycles -> route: each cycle opened at its point nearest to `start` (or to where the
/// part before ended), parts joined by transits through the water. `fan[region]` is the fan of a
/// region; `region_of` may be empty, then fan[0] holds everywhere. `blocked`: edges that smoothing
/// must not take the path across.
[[nodiscard]] Route skeleton_route(const std::vector<SkeletonCycle>& cycles,
                                   const std::vector<std::uint32_t>& region_of,
                                   const std::vector<FanAngles>& fans, const PlanningGround& ground,
                                   const PlanOptions& options, std::vector<std::string>& notes,
                                   const std::vector<std::pair<Vec2, Vec2>>& blocked = {});

}  // namespace swathplan

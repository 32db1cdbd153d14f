#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "planners/plan.h"
#include "planners/rows/route_builder.h"

namespace swathplan {

/// A point of a NUC skeleton: the centroid of a sub-facet, or a point of an edge. The second kind
/// stands where the straight way between two sub-facets would miss the half-edge that they share.
struct SkeletonPoint {
  Vec2 position = Vec2::Zero();
  std::uint32_t face = 0;
  std::uint16_t corner = 0;  ///< the sub-facet is the quad at this corner of the face
  bool sub_facet = true;     ///< false for a point on an edge
  float ahead_m = 0.0F;      ///< the part of the way to the next point that lies in this face
  float behind_m = 0.0F;     ///< the part of the way from the point before that lies in it
};

/// A closed path through every sub-facet of one connected part of a mesh.
using SkeletonCycle = std::vector<SkeletonPoint>;

/// Non-revisiting uniform coverage. Each facet with n corners is cut into n quads (corner, two edge
/// midpoints, barycentre), and the centroids of these form a cycle. Then the facets are walked
/// along a spanning tree. The cycle of a child is spliced into that of its parent, between the two
/// quads that touch their shared edge. `open[i]`: whether the path may cross shared edge i; empty:
/// all. Guarantees, for convex faces: (1) every sub-facet is visited once; (2) no cycle crosses
/// itself; (3) no edge that is not open is crossed, a tree edge is crossed once in and once out;
/// (4) one cycle per part that open edges connect, in the order of their lowest face. Degenerate: a
/// single face gives its own cycle; an empty mesh none. Cost: O(n) time and memory (linked splice).
/// Method: [yang-nuc], [larrazabal-mdnuc] section III.A.
[[nodiscard]] std::vector<SkeletonCycle> nuc_skeleton(const PlanarMesh& mesh,
                                                      const std::vector<SharedEdge>& edges,
                                                      const std::vector<char>& open = {});

/// NUC on the whole survey area with one opening angle from its mean depth.
[[nodiscard]] Plan plan_nuc(const Ground& ground, const PlanOptions& options);

/// The path along skeleton points `p` with each corner rounded by an arc. The arc touches the ways
/// to and from the corner, at most half-way along them, and stays in the corner's own face. So the
/// path crosses neither itself nor an edge that the skeleton does not cross. An arc is shorter than
/// the corner, and its fan sweeps the outside of the corner, which a jump in course leaves empty.
/// An arc is as wide as `radius_m` where that fits. Its chords turn by at most `kArcStepDeg`
/// degrees.
[[nodiscard]] std::vector<SkeletonPoint> rounded(const std::vector<SkeletonPoint>& p,
                                                 double radius_m = 0.0);
inline constexpr double kArcStepDeg = 3.0;

/// Makes a route of skeleton cycles. Each cycle is opened at its point nearest to `start`, or to
/// the end of the part before it. Transits through the water join the parts. `fans[region]` is the
/// fan of a region. If `region_of` is empty, fans[0] holds everywhere. `blocked`: edges that the
/// smoothed path must not cross.
[[nodiscard]] Route skeleton_route(const std::vector<SkeletonCycle>& cycles,
                                   const std::vector<std::uint32_t>& region_of,
                                   const std::vector<FanAngles>& fans, const Ground& ground,
                                   const PlanOptions& options, const Connector& connector,
                                   std::vector<std::string>& notes,
                                   const std::vector<std::pair<Vec2, Vec2>>& blocked = {});

}  // namespace swathplan

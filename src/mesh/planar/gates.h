#pragma once

#include <cstdint>
#include <vector>

#include "mesh/planar/depth_regions.h"

namespace swathplan {

/// The one shared edge through which a path may pass between two neighbouring depth regions.
struct Gate {
  std::uint32_t edge;                ///< index into the shared edges
  std::uint32_t region_a, region_b;  ///< region_a < region_b
  Angle slope;                       ///< slope of the seafloor across the edge
};

/// The gates of the spanning tree of regions. Every other edge between regions is blocked.
struct Gates {
  std::vector<Gate> gates;                   ///< by (region_a, region_b)
  std::vector<std::uint32_t> blocked_edges;  ///< indices into the shared edges, ascending
};

/// Chooses for each pair of neighbouring regions the edge across which the seafloor slopes least.
/// Of equal slopes it takes the longest edge, then the first. A spanning tree of the regions,
/// lowest slope first, keeps some of these. So each region is entered once, even where regions form
/// a ring. Method: [larrazabal-mdnuc] section III.B.2-3.
[[nodiscard]] Gates choose_gates(const PlanarMesh& mesh, const std::vector<SharedEdge>& edges,
                                 const DepthRegions& regions, const DepthQuery& depths);

}  // namespace swathplan

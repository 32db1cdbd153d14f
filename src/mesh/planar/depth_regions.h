#pragma once

#include <cstdint>
#include <vector>

#include "mesh/planar/planar_mesh.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// Limits between depth bands: `count` equal bands over the depths, or explicit depths.
struct DepthBands {
  int count = 2;               ///< >= 1; used when `limits` is empty
  std::vector<double> limits;  ///< depths in metres, ascending, between the bands
};

/// One connected set of faces in one depth band.
struct DepthRegion {
  int band = 0;                      ///< 0 is the shoalest band
  std::vector<std::uint32_t> faces;  ///< ascending
  double mean_depth_m = 0.0;         ///< plan-area-weighted over the seafloor below the faces
  double min_depth_m = 0.0, max_depth_m = 0.0;
  double area_m2 = 0.0;
};

/// The partition of a planar mesh by depth.
struct DepthRegions {
  std::vector<double> band_limits_m;     ///< between bands, ascending
  std::vector<DepthRegion> regions;      ///< by their lowest face
  std::vector<std::uint32_t> region_of;  ///< region per face
};

struct DepthRegionOptions {
  DepthBands bands;
  double smallest_region_m2 = 0.0;  ///< smaller regions join the neighbour with the longest border
};

/// Gives each face the band of its mean depth. Faces of one band that hang together make a region.
/// Regions that are too small join a neighbour. Method: [larrazabal-mdnuc] section III.B.2.
/// @throws UsageError for limits that are not ascending, or for a band that holds no face of the
///   mesh; the message names the band.
[[nodiscard]] DepthRegions depth_regions(const PlanarMesh& mesh,
                                         const std::vector<SharedEdge>& edges,
                                         const DepthQuery& depths,
                                         const DepthRegionOptions& options);

/// The faces of a region, united.
[[nodiscard]] Area region_outline(const PlanarMesh& mesh, const DepthRegion& region);

}  // namespace swathplan

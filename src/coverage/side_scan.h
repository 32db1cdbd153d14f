#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "coverage/tracing/ray_scene.h"
#include "mesh/seafloor.h"

namespace swathplan {

/// A side-scan sonar and how it is carried. Nominal, for simulation.
struct SideScanSonar {
  double range_m = 50.0;               ///< horizontal reach of each side, > 0
  double pixel_m = 0.1;                ///< across-track size of an image pixel, on a flat bottom
  double ping_spacing_m = 0.2;         ///< along the track
  double altitude_m = 6.0;             ///< above the seafloor, kept as far as the surface allows
  double nadir_gap_m = 0.0;            ///< half-width without data below the sonar, >= 0
  int rays_per_pixel = 2;              ///< along each side's fan
  double attenuation_db_per_m = 0.05;  ///< loss with range that the receiver's gain does not mend
  double looks = 4.0;      ///< of the speckle: its relative deviation is 1 / sqrt(looks); 0: none
  std::uint64_t seed = 1;  ///< of the speckle
};
/// @throws UsageError if a value breaks its rule; the message names it.
void check(const SideScanSonar& sonar);

/// An image of one track: a row per ping, columns from the track outwards, intensities >= 0.
/// 0 in shadow and where there is no data.
struct SideScanImage {
  int rows = 0, columns = 0;
  double pixel_m = 0.1, row_m = 0.2;
  double nadir_gap_m = 0.0;            ///< columns nearer than this hold no data
  std::vector<float> port, starboard;  ///< rows x columns each
};

/// Heights of the seafloor below a track, as a multibeam sonar over the nadir gap gives them. A row
/// per ping; columns from `half_width_m` to port to as much to starboard; z in metres, NaN where
/// nothing was met.
struct NadirHeights {
  int rows = 0, columns = 0;
  double pixel_m = 0.1, row_m = 0.2;
  std::vector<float> z;
};
[[nodiscard]] NadirHeights nadir_heights(const RayScene& scene, const Vec2& from, const Vec2& to,
                                         const std::function<double(const Vec2&)>& depth_below,
                                         double half_width_m, const SideScanSonar& sonar);

/// Sails from `from` to `to` (local metres) and makes the image. The rays of each side fan out from
/// the vertical. Where a ray meets the scene, its slant range gives the pixel, as on a flat bottom
/// below the sonar; its grazing angle (Lambert) and its range give the intensity. What no ray meets
/// is shadow. `depth_below` gives the seafloor's depth below a point, positive down; the vehicle
/// keeps its altitude above that.
/// The same seed gives the same image. Cost: about rows x columns x rays_per_pixel x 2.25 rays.
/// Throws as check.
[[nodiscard]] SideScanImage side_scan_image(const RayScene& scene, const Vec2& from, const Vec2& to,
                                            const std::function<double(const Vec2&)>& depth_below,
                                            const SideScanSonar& sonar);

/// The height at which the vehicle sails over such a depth: z, metres. It stays half a metre below
/// the water level, but where water is too shoal it stays half a metre above the seafloor.
[[nodiscard]] double sonar_height_m(double depth_below_m, const SideScanSonar& sonar);

}  // namespace swathplan

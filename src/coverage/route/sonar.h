#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coverage/route/route.h"
#include "mesh/base/angle.h"

namespace swathplan {

enum class BeamSpacing { equiangular, equidistant };

/// Soundings farther from nadir than `half_angle` are lost where the seafloor lies `depth_m` below
/// the sonar. Between two limits the angle changes linearly with the depth.
struct CoverageLimit {
  double depth_m = 0.0;
  Angle half_angle;
};

/// A multibeam echo sounder. Presets are nominal: your data sheet has the true figures.
struct Sonar {
  std::string name = "norbit-iwbms";
  int beams = 256;  ///< >= 2
  BeamSpacing spacing = BeamSpacing::equiangular;
  Angle beam_width_along = Angle::degrees(1.9);
  Angle beam_width_across = Angle::degrees(0.9);
  Angle max_opening = Angle::degrees(160);  ///< full fan, (0, 180) degrees
  double max_ping_rate_hz = 60.0;           ///< > 0
  double max_range_m = 275.0;
  bool dual_swath = false;  ///< two fans a cycle
  /// How wide the fan still sees at a depth. Empty: as far as the range goes.
  std::vector<CoverageLimit> coverage_curve = {};
};

[[nodiscard]] std::vector<Sonar> sonar_presets();
/// Empty if there is no such preset.
[[nodiscard]] std::optional<Sonar> sonar_preset(std::string_view name);

/// Footprint width W = beams x resolution, metres.
[[nodiscard]] double footprint_width_m(const Sonar& sonar, double resolution_m);
/// Half-angle whose two sides together sweep `width_m` at `depth_m`: atan(width / 2 / depth), but
/// no more than the sonar's.
[[nodiscard]] Angle half_angle(const Sonar& sonar, double width_m, double depth_m);
/// Widest half-angle whose outermost beam still meets level ground `depth_m` below the sonar within
/// its reach and its largest opening; 0 where not even the beam straight down does.
[[nodiscard]] Angle widest_half_angle(const Sonar& sonar, double depth_m);
/// Gap-free half-angle t: the largest at which neighbouring equiangular beams on flat ground lie no
/// farther apart than `cell_m`. It solves 2 t sec^2(t) depth / (beams - 1) = cell, and is no more
/// than the sonar's.
[[nodiscard]] Angle gap_free_half_angle(const Sonar& sonar, double depth_m, double cell_m);
/// Slant range up to which a beam at `angle` from nadir gives soundings, metres: the sonar's range,
/// or less by its coverage curve.
[[nodiscard]] double reach_m(const Sonar& sonar, Angle angle);
/// Angles of the beams from nadir, port negative, ascending.
[[nodiscard]] std::vector<double> beam_angles_rad(const Sonar& sonar, const FanAngles& fan);

}  // namespace swathplan

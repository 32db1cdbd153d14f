#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// A survey vehicle. Presets are nominal: measure your own.
struct Vehicle {
  std::string name = "wam-v";
  double speed_mps = 2.0;            ///< on lines
  double turn_speed_mps = 1.5;       ///< in turns between lines
  double transit_speed_mps = 2.0;    ///< between areas
  double turn_radius_m = 1.5;        ///< smallest
  double draft_m = 0.3;              ///< depth of the sonar and keel below the water line
  double under_keel_margin_m = 0.5;  ///< water wanted below the keel
  double squat_m = 0.0;              ///< deeper by this under way
  double clearance_m = 0.0;          ///< kept from walls, shoals and no-go areas
  double beam_m = 0.0;               ///< width of the hull
  double position_error_m = 0.5;     ///< how far off its line the boat may be
  double wall_margin_m = 0.5;        ///< room wanted between hull and wall
  double endurance_h = 8.0;          ///< longest time under way
  double contingency = 0.1;          ///< allowance for what goes wrong, share of the duration, >= 0
  std::optional<double> power_w = std::nullopt;  ///< mean draw under way; empty: not known
};

[[nodiscard]] std::vector<Vehicle> vehicle_presets();
/// Empty if there is no such preset.
[[nodiscard]] std::optional<Vehicle> vehicle_preset(std::string_view name);
/// Clearance by practice: half the beam, the position error and the margin to walls, metres.
[[nodiscard]] double practical_clearance_m(const Vehicle& vehicle);
/// Shoalest depth that the vehicle enters: draft + squat + margin.
[[nodiscard]] double safe_depth_m(const Vehicle& vehicle);

}  // namespace swathplan

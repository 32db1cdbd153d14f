#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swathplan {

/// A survey vehicle. Presets are nominal: check your own.
struct Vehicle {
  std::string name = "wam-v";
  double speed_mps = 2.0;            ///< on lines
  double turn_radius_m = 1.5;        ///< smallest
  double draft_m = 0.3;              ///< depth of the sonar and keel below the water line
  double under_keel_margin_m = 0.5;  ///< water wanted below the keel
};

[[nodiscard]] std::vector<Vehicle> vehicle_presets();
/// Empty if there is no such preset.
[[nodiscard]] std::optional<Vehicle> vehicle_preset(std::string_view name);
/// Shoalest depth that the vehicle enters: draft + margin.
[[nodiscard]] double safe_depth_m(const Vehicle& vehicle);

}  // namespace swathplan

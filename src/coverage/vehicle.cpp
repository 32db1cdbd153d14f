#include "coverage/vehicle.h"

namespace swathplan {

std::vector<Vehicle> vehicle_presets() {
  return {
      {.name = "wam-v", .speed_mps = 2.0, .turn_radius_m = 1.5, .draft_m = 0.3},
      {.name = "small-usv", .speed_mps = 2.0, .turn_radius_m = 5.0, .draft_m = 0.5},
      {.name = "launch", .speed_mps = 2.5, .turn_radius_m = 25.0, .draft_m = 1.0},
  };
}

std::optional<Vehicle> vehicle_preset(std::string_view wanted) {
  for (Vehicle& vehicle : vehicle_presets()) {
    if (vehicle.name == wanted) return vehicle;
  }
  return std::nullopt;
}

double safe_depth_m(const Vehicle& vehicle) {
  return vehicle.draft_m + vehicle.under_keel_margin_m;
}

}  // namespace swathplan

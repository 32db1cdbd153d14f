#include "coverage/route/vehicle.h"

namespace swathplan {

std::vector<Vehicle> vehicle_presets() {
  return {
      {.name = "wam-v",
       .speed_mps = 2.0,
       .turn_speed_mps = 1.5,
       .transit_speed_mps = 2.0,
       .turn_radius_m = 1.5,
       .draft_m = 0.3,
       .clearance_m = 0.05,
       .beam_m = 2.4},
      {.name = "small-usv",
       .speed_mps = 2.0,
       .turn_speed_mps = 1.5,
       .transit_speed_mps = 2.5,
       .turn_radius_m = 5.0,
       .draft_m = 0.5,
       .squat_m = 0.05,
       .clearance_m = 0.05,
       .beam_m = 1.0,
       .endurance_h = 6.0},
      {.name = "launch",
       .speed_mps = 2.5,
       .turn_speed_mps = 2.0,
       .transit_speed_mps = 5.0,
       .turn_radius_m = 25.0,
       .draft_m = 1.0,
       .squat_m = 0.2,
       .clearance_m = 0.05,
       .beam_m = 4.0},
      {.name = "auv",
       .speed_mps = 1.5,
       .turn_speed_mps = 1.5,
       .transit_speed_mps = 1.5,
       .turn_radius_m = 15.0,
       .draft_m = 0.5,
       .clearance_m = 0.05,
       .beam_m = 0.4,
       .endurance_h = 12.0},
  };
}

std::optional<Vehicle> vehicle_preset(std::string_view wanted) {
  for (Vehicle& vehicle : vehicle_presets()) {
    if (vehicle.name == wanted) return vehicle;
  }
  return std::nullopt;
}

double practical_clearance_m(const Vehicle& vehicle) {
  return 0.5 * vehicle.beam_m + vehicle.position_error_m + vehicle.wall_margin_m;
}

double safe_depth_m(const Vehicle& vehicle) {
  return vehicle.draft_m + vehicle.squat_m + vehicle.under_keel_margin_m;
}

}  // namespace swathplan

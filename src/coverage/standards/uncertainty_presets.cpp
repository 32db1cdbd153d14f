#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "coverage/standards/uncertainty.h"
#include "mesh/base/error.h"

namespace swathplan {

namespace {

template <class Preset>
Preset preset_named(const std::vector<Preset>& presets, const char* option, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Preset& preset : presets) {
    if (preset.name == name) return preset;
    names.push_back(preset.name);
  }
  throw UsageError(option, std::string(name),
                   fmt::format("must be one of {}", fmt::join(names, ", ")));
}

}  // namespace

std::vector<PositioningPreset> positioning_presets() {
  return {
      {"gnss", "satellites alone", 2.0, 0.010, std::nullopt},
      {"dgnss", "with corrections by radio or satellite", 0.5, 0.005, std::nullopt},
      {"rtk", "carrier phase, heights with it", 0.02, 0.005, 0.04},
      {"ppk-ins", "carrier phase, smoothed afterwards with an INS", 0.02, 0.001, 0.03},
  };
}

std::vector<MotionSensorPreset> motion_sensor_presets() {
  return {
      {"ahrs", "small attitude sensor, magnetic heading", 0.25, 0.25, 1.5, 0.10, 0.10},
      {"mru", "motion sensor with a satellite compass", 0.05, 0.05, 0.15, 0.05, 0.05},
      {"ins", "survey-grade INS", 0.02, 0.02, 0.03, 0.05, 0.05},
      {"ppk-ins", "survey-grade INS, smoothed afterwards", 0.01, 0.01, 0.02, 0.02, 0.02},
  };
}

std::vector<SonarUncertaintyPreset> sonar_uncertainty_presets() {
  // Beam angle: a tenth of the beam's width across.
  return {
      {"norbit-iwbms", 0.02, 0.09}, {"norbit-iwbms-512", 0.02, 0.09}, {"r2sonic-2024", 0.02, 0.05},
      {"reson-t50", 0.02, 0.05},    {"em2040", 0.02, 0.10},
  };
}

void use_positioning(std::string_view name, UncertaintyBudget& budget) {
  const PositioningPreset preset = preset_named(positioning_presets(), "positioning", name);
  budget.position_m = preset.position_m;
  budget.timing_s = preset.timing_s;
  if (preset.water_level_m) budget.water_level_m = preset.water_level_m;
}

void use_motion_sensor(std::string_view name, UncertaintyBudget& budget) {
  const MotionSensorPreset preset = preset_named(motion_sensor_presets(), "motion sensor", name);
  budget.roll = Angle::degrees(preset.roll_deg);
  budget.pitch = Angle::degrees(preset.pitch_deg);
  budget.heading = Angle::degrees(preset.heading_deg);
  budget.heave_m = preset.heave_m;
  budget.heave_share = preset.heave_share;
}

void use_sonar(std::string_view name, UncertaintyBudget& budget) {
  const std::vector<SonarUncertaintyPreset> presets = sonar_uncertainty_presets();
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const auto& preset) { return preset.name == name; });
  if (found == presets.end()) return;
  budget.range_m = found->range_m;
  budget.beam_angle = Angle::degrees(found->beam_angle_deg);
}

}  // namespace swathplan

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/base/angle.h"

namespace swathplan {

/// What is known of each thing that a sounding is computed from: one standard deviation each.
/// Empty: nobody gave it; a sounding's uncertainty is then refused, never computed without it.
struct UncertaintyBudget {
  std::optional<double> range_m;    ///< slant range
  std::optional<Angle> beam_angle;  ///< of a beam, as the sonar finds it
  Angle beam_width_along;           ///< the beam's full width along the course; no deviation

  double sound_speed_mps = 1500.0;             ///< mean of the water column, > 0; no deviation
  std::optional<double> mean_sound_speed_mps;  ///< of that mean
  std::optional<double> head_sound_speed_mps;  ///< of the speed at the sonar head

  std::optional<Angle> roll, pitch, heading;
  std::optional<double> heave_m;  ///< fixed part
  double heave_share = 0.0;       ///< ... or this share of the expected heave, whichever is more
  double expected_heave_m = 0.0;  ///< of the sea; no deviation

  std::optional<double> position_m;  ///< horizontal, in each direction
  std::optional<double> timing_s;    ///< between position and ping
  std::optional<double> draft_m, squat_m;
  std::optional<double> water_level_m;  ///< tide, or height and separation model
};

/// The names of the deviations that nobody gave, as options are named: "roll uncertainty".
[[nodiscard]] std::vector<std::string> missing(const UncertaintyBudget& budget);

/// Where a sounding lies as the sonar sees it.
struct SoundingGeometry {
  Angle from_vertical;     ///< [0, 90) degrees, to either side
  double range_m = 0.0;    ///< slant range
  double speed_mps = 0.0;  ///< of the boat
};

/// Total vertical and horizontal uncertainty, both at 95 %, metres.
struct SoundingUncertainty {
  double tvu_m = 0.0, thu_m = 0.0;
};

/// The budget made ready for many soundings.
/// Method: Hare, 'Depth and position error budgets for multibeam echosounding' (1995); the formulas
/// stand in docs/uncertainty.md.
class UncertaintyModel {
 public:
  /// @throws UsageError if a deviation is missing (all of them are named), negative or not finite.
  explicit UncertaintyModel(const UncertaintyBudget& budget);
  [[nodiscard]] SoundingUncertainty of(const SoundingGeometry& sounding) const;
  /// The same from the cosine of the angle from the vertical, (0, 1].
  [[nodiscard]] SoundingUncertainty of_beam(double cosine, double range_m, double speed_mps) const;

 private:
  friend struct UncertaintyParts;
  double range2_, beam_angle2_, roll2_, pitch2_, heading2_;  // squares
  double mean_speed2_, head_speed2_;                         // of the share of the sound speed
  double half_beam_;                                         // 1 - cos(half of the beam's width)
  double heave2_, draft2_, squat2_, water_level2_;
  double position2_, timing2_;
};

/// As UncertaintyModel, for one sounding.
[[nodiscard]] SoundingUncertainty sounding_uncertainty(const UncertaintyBudget& budget,
                                                       const SoundingGeometry& sounding);

/// What one source adds to the uncertainty of a depth: one standard deviation, metres.
struct UncertaintyPart {
  std::string_view source;
  double sigma_m = 0.0;
};
/// The parts whose squares add up to that of the depth, in the order of the formula.
[[nodiscard]] std::vector<UncertaintyPart> depth_parts(const UncertaintyBudget& budget,
                                                       const SoundingGeometry& sounding);

/// Positioning; nominal, check your own.
struct PositioningPreset {
  std::string_view name, what;
  double position_m, timing_s;
  std::optional<double> water_level_m;  ///< where heights come with the position
};
[[nodiscard]] std::vector<PositioningPreset> positioning_presets();

/// A motion sensor; nominal, check your own.
struct MotionSensorPreset {
  std::string_view name, what;
  double roll_deg, pitch_deg, heading_deg;
  double heave_m, heave_share;
};
[[nodiscard]] std::vector<MotionSensorPreset> motion_sensor_presets();

/// What a sonar adds; nominal, check your own. Named as the presets of sonar.h.
struct SonarUncertaintyPreset {
  std::string_view name;
  double range_m, beam_angle_deg;
};
[[nodiscard]] std::vector<SonarUncertaintyPreset> sonar_uncertainty_presets();

/// Fill what the preset knows. @throws UsageError for a name that is no preset, with all names.
void use_positioning(std::string_view name, UncertaintyBudget& budget);
void use_motion_sensor(std::string_view name, UncertaintyBudget& budget);
/// A sonar that has no row leaves the budget as it is.
void use_sonar(std::string_view name, UncertaintyBudget& budget);

}  // namespace swathplan

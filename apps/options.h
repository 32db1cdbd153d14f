#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/option_table.h"

// What may be typed, as it is typed, and the rows of the table that fill it. survey.h resolves it.
namespace swathplan {

/// How the seafloor file is read and what bounds the survey.
struct SiteOptions {
  std::filesystem::path file;
  std::string crs, columns;
  double water_level_m = 0.0, chart_datum_offset_m = 0.0;
  std::string z_positive = "up", up = "ask";
  std::optional<double> z_unit_m, xy_unit_m, longest_edge_m, nodata_value;
  std::filesystem::path area, no_go;
  std::vector<std::string> layers;   ///< of these files; empty: the only one
  double buffer_m = 0.0;             ///< room around their lines and points; 0: these do not count
  double run_out_margin_m = 0.0;     ///< beyond the data's edge where the boat may turn
  std::filesystem::path keep_off;    ///< not sailed over, but to be seen
  std::vector<std::string> mosaic;   ///< further files of the same seafloor
  std::string priority = "finest";   ///< which of them counts where several have data
  std::vector<std::string> hazards;  ///< as parse_hazards() reads them
  double chart_margin_m = 1000.0;    ///< of a chart, how much around the area is used
};

/// When the survey is sailed, and the tide then.
struct WaterChoice {
  std::filesystem::path tide;
  std::string depart;
};

/// What was surveyed before.
struct CoveredChoice {
  std::vector<std::string> files;
  std::optional<double> swath_m, opening_deg;
};

/// A preset and what overrides it.
struct SonarChoice {
  std::string preset = "norbit-iwbms";
  std::optional<int> beams;
  std::string beam_spacing = "equiangular";
  std::optional<double> max_opening_deg, ping_rate_hz;
  std::string swaths = "preset", coverage_curve;
};

/// A preset and what overrides it.
struct VehicleChoice {
  std::string preset = "wam-v";
  std::optional<double> draft_m, margin_m, squat_m, clearance_m, turn_radius_m;
  std::optional<double> beam_m, position_error_m, wall_margin_m;
  std::optional<double> speed_mps, turn_speed_mps, transit_speed_mps;
  std::optional<double> endurance_h, contingency_pct, power_w;
};

/// Tracking errors: a preset and what overrides it.
struct NoiseChoice {
  std::string preset = "none";
  std::optional<double> lateral_sigma_m, heading_sigma_deg, roll_sigma_deg, heave_sigma_m;
  std::uint64_t seed = 1;
};

/// How routes are scored.
struct ScoringChoice {
  double resolution_m = 0.10;
  std::optional<double> ping_spacing_m;
  double sound_speed_mps = 1500.0;
  std::string nodata = "wall";
  double holiday_m2 = 1.0;
  bool hit_only = false;
  int threads = 0;
};

/// How routes are planned.
struct PlanningChoice {
  std::string depth_bands = "2";
  std::optional<double> smallest_region_m2;
  std::string faces = "triangle";
  std::optional<double> face_size;
  std::string opening = "region", smooth = "none";
  double run_in_m = 0.0, run_out_m = 0.0;
  std::string start;
  std::optional<double> heading_deg;
  std::string north = "true";
  std::string lines = "auto";
  std::optional<double> goal_coverage_pct, goal_length_m, goal_time_h;
  std::string cover = "hit", counted = "logged", angles = "line";
  std::optional<double> least_line_m, least_speed_mps, soundings;
  double line_margin_pct = 0.0;
  std::string swath_by = "fan", spacing_depth;
  std::optional<double> spacing_m, overlap_pct, opening_deg;
};

/// What a survey is judged by, and how well its soundings are known: presets and what overrides
/// them.
struct CriteriaChoice {
  std::string criterion = "none";
  bool require_pass = false, smooth_seafloor = false;
  std::string positioning = "none", motion_sensor = "none";
  std::optional<double> range_m, beam_angle_deg;
  double sound_speed_mps = 1.0, head_sound_speed_mps = 0.25;
  std::optional<double> roll_deg, pitch_deg, heading_deg, heave_m, heave_share_pct;
  double expected_heave_m = 0.0;
  std::optional<double> position_m, timing_s, water_level_m;
  double draft_m = 0.02, squat_m = 0.02;
};

/// What is planned and scored with.
struct SurveyOptions {
  std::string profile = "survey";
  SonarChoice sonar;
  VehicleChoice vehicle;
  NoiseChoice noise;
  ScoringChoice scoring;
  CriteriaChoice criteria;
  PlanningChoice planning;
};

/// What a plan is beside its main scheme.
struct JobChoice {
  std::filesystem::path keep;  ///< a route whose lines are planned with
  std::string beside;          ///< a file of lines, points or polygons, or X,Y
  std::optional<int> beside_lines;
  std::string berth;
  std::optional<double> cross_lines_pct, sortie_h, battery_wh;
  bool patch_test = false;
  std::string daylight;
  int boats = 1;
};

struct OutputOptions {
  std::filesystem::path folder = "out";
  bool json = false, quiet = false;
};

/// The files that other programs read, of `plan`, `compare`, `lines` and `export`.
struct ExportChoice {
  std::vector<std::string> formats;
  double tolerance_m = 0.10;
  std::uint64_t mission_items = 0;
};

/// FILE and how to read it, with what is kept off; optional where a command works without.
[[nodiscard]] OptionTable site_options(SiteOptions& site, bool with_file = true);
/// Tide and departure: of `plan`, `compare` and `score`.
[[nodiscard]] OptionTable water_options(WaterChoice& water);
/// Earlier surveys: of `plan`, `compare` and `score`.
[[nodiscard]] OptionTable covered_options(CoveredChoice& covered);
/// The row that names the profile; command_line.cpp fills from it what nobody gave.
[[nodiscard]] Option profile_option(std::string& profile);
[[nodiscard]] OptionTable vehicle_options(VehicleChoice& vehicle);
/// Scoring, sonar, vehicle and tracking errors.
[[nodiscard]] OptionTable scoring_options(SurveyOptions& survey);
/// Of `plan` and `score`.
[[nodiscard]] OptionTable criteria_options(CriteriaChoice& criteria);
[[nodiscard]] OptionTable planning_options(PlanningChoice& planning);
/// What a line's swath is: a row of all commands that open fans.
[[nodiscard]] Option swath_option(const std::string& group, std::string& swath_by);
/// Of `plan`.
[[nodiscard]] OptionTable job_options(JobChoice& job);
/// Which north a heading counts from: a row of all commands that take one.
[[nodiscard]] Option north_option(const std::string& group, std::string& north);
/// Of `plan`, `compare` and `lines`, in a group of their own.
[[nodiscard]] OptionTable exporting_options(ExportChoice& choice);
/// The row that `export` shares with them.
[[nodiscard]] Option mission_items_option(const std::string& group, ExportChoice& choice);
[[nodiscard]] OptionTable output_options(OutputOptions& output);

/// The sentence with its '<z unit>' as '--z-unit': libraries do not know flags and write the names
/// of options between these brackets. Names that are none lose their brackets only.
[[nodiscard]] std::string in_flags(const std::string& sentence);
/// What an error says, in flags.
[[nodiscard]] std::string in_flags(const std::exception& error);

}  // namespace swathplan

#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coverage/score.h"
#include "io/results/provenance.h"
#include "io/seafloor/import_seafloor.h"
#include "planners/plan.h"

namespace swathplan {

/// How the seafloor file is read and what bounds the survey.
struct SiteOptions {
  std::filesystem::path file;
  std::string crs;
  double water_level = 0.0;
  std::string z_positive = "up";
  std::string z_unit = "metre";
  std::optional<double> xy_unit_m, longest_edge_m, nodata_value;
  std::filesystem::path area, no_go;
  double run_out_margin_m = 0.0;  ///< beyond the data's edge where the boat may turn
};

/// What is planned and scored with. Text where the command line takes text; resolved() checks it.
struct SurveyOptions {
  double resolution_m = 0.10;
  double ping_spacing_m = 0.10;
  std::string sonar = "norbit-iwbms";
  std::optional<int> beams;
  std::optional<double> max_opening_deg;
  std::string beam_spacing = "equiangular";
  std::string vehicle = "wam-v";
  std::optional<double> draft_m, margin_m, squat_m, clearance_m;
  std::optional<double> speed_mps, turn_speed_mps, transit_speed_mps, turn_radius_m;
  std::optional<double> endurance_h, contingency_pct, power_w;
  double run_in_m = 0.0, run_out_m = 0.0;
  std::string smooth = "none";
  std::string depth_bands = "2";
  std::optional<double> smallest_region_m2;
  std::string faces = "triangle";
  std::optional<double> face_size;
  std::string opening = "region";
  std::string start;
  std::optional<double> heading_deg;
  std::string lines = "auto";
  std::optional<double> goal_coverage_pct, goal_length_m, goal_time_h;
  std::string cover = "hit";
  double line_margin_pct = 0.0;
  std::string nodata = "wall";
  std::string noise = "none";
  std::optional<double> lateral_sigma_m, heading_sigma_deg, roll_sigma_deg, heave_sigma_m;
  double holiday_m2 = 1.0;
  bool hit_only = false;
  std::uint64_t seed = 1;
  int threads = 0;
};

struct OutputOptions {
  std::filesystem::path folder = "out";
  bool json = false, quiet = false;
};

void add_site_options(CLI::App& command, SiteOptions& options);
void add_planning_options(CLI::App& command, SurveyOptions& options);
void add_scoring_options(CLI::App& command, SurveyOptions& options);
void add_output_options(CLI::App& command, OutputOptions& options);

/// @throws UsageError that names the option, its value and the rule.
[[nodiscard]] ImportOptions import_options(const SiteOptions& options);
/// `frame` turns --start from file coordinates into local ones.
[[nodiscard]] PlanOptions plan_options(const SurveyOptions& options, const Frame& frame);
[[nodiscard]] ScoreOptions score_options(const SurveyOptions& options);
[[nodiscard]] Vehicle vehicle_of(const SurveyOptions& options);
[[nodiscard]] Sonar sonar_of(const SurveyOptions& options);

/// The options as they were in force, for the provenance in outputs.
[[nodiscard]] Provenance provenance_of(const std::string& command, const SiteOptions& site,
                                       const SurveyOptions& survey, const std::string& input_hash);

}  // namespace swathplan

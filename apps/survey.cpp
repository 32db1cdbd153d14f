#include "apps/survey.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

#include "mesh/base/error.h"
#include "planners/nuc/skeleton_smoothing.h"

namespace swathplan {
namespace {

double number(const std::string& text, const char* option) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw UsageError(fmt::format("{}: '{}' is not a number", option, text));
  }
  return value;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

/// '4': so many equal bands; '10,20' or '15.0': the depths between them.
DepthBands bands(const std::string& text) {
  DepthBands result;
  if (text.find_first_of(",.") == std::string::npos) {
    const double count = number(text, "--depth-bands");
    if (!(count >= 1.0 && count <= 100.0) || count != std::floor(count)) {
      throw UsageError(fmt::format(
          "--depth-bands {}; must be a whole number of 1 to 100 equal bands, or depths as in "
          "'10,20' ('15.0' for a single one)",
          text));
    }
    result.count = static_cast<int>(count);
    return result;
  }
  for (const std::string& part : split(text, ',')) {
    if (part.empty()) continue;
    result.limits.push_back(number(part, "--depth-bands"));
    const std::size_t n = result.limits.size();
    if (!(result.limits.back() > 0.0) ||
        (n > 1 && !(result.limits[n - 1] > result.limits[n - 2]))) {
      throw UsageError(fmt::format(
          "--depth-bands {}; the depths between bands must be above 0 metres and ascending", text));
    }
  }
  if (result.limits.empty()) {
    throw UsageError("--depth-bands: no depth given; write '10,20' or a number of bands");
  }
  return result;
}

Vec2 start_point(const std::string& text) {
  const auto parts = split(text, ',');
  if (parts.size() != 2) {
    throw UsageError(fmt::format(
        "--start '{}'; must be X,Y in the coordinates of the seafloor file, as in '150,20'", text));
  }
  return {number(parts[0], "--start"), number(parts[1], "--start")};
}

/// '20:65,100:60': half-angles in degrees over depths in metres.
std::vector<CoverageLimit> coverage_curve(const std::string& text) {
  std::vector<CoverageLimit> curve;
  for (const std::string& part : split(text, ',')) {
    const std::vector<std::string> pair = split(part, ':');
    if (pair.size() != 2) {
      throw UsageError(fmt::format(
          "--coverage-curve '{}'; must be pairs of depth and half-angle, as in '20:65,100:60'",
          text));
    }
    const CoverageLimit limit{number(pair[0], "--coverage-curve"),
                              Angle::degrees(number(pair[1], "--coverage-curve"))};
    const bool falls = curve.empty() || (limit.depth_m > curve.back().depth_m &&
                                         limit.half_angle < curve.back().half_angle);
    if (!falls || limit.depth_m < 0.0 || limit.half_angle.deg() < 0.0 ||
        limit.half_angle.deg() >= 90.0) {
      throw UsageError(fmt::format(
          "--coverage-curve '{}'; depths must be 0 metres or more and ascend, half-angles must "
          "lie under 90 degrees and descend",
          text));
    }
    curve.push_back(limit);
  }
  return curve;
}

void set_if(double& value, const std::optional<double>& given) {
  if (given) value = *given;
}

void keep(std::optional<double>& given, double in_force) {
  if (!given) given = in_force;
}

TrackNoise noise_of(const NoiseChoice& o) {
  TrackNoise noise;
  noise.seed = o.seed;
  if (o.preset == "calm" || o.preset == "rough") {
    const bool calm = o.preset == "calm";
    noise.lateral_sigma_m = calm ? 0.3 : 1.0;
    noise.heading_sigma = Angle::degrees(calm ? 2.0 : 4.0);
  }
  set_if(noise.lateral_sigma_m, o.lateral_sigma_m);
  set_if(noise.heave_sigma_m, o.heave_sigma_m);
  if (o.heading_sigma_deg) noise.heading_sigma = Angle::degrees(*o.heading_sigma_deg);
  if (o.roll_sigma_deg) noise.roll_sigma = Angle::degrees(*o.roll_sigma_deg);
  return noise;
}

/// @throws UsageError for what is typed of a judgement that is not asked for.
void refuse_idle(const CriteriaChoice& typed) {
  CriteriaChoice given = typed;
  CriteriaChoice untouched;
  const OptionTable rows = criteria_options(given);
  const OptionTable defaults = criteria_options(untouched);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (value_of(rows[i]) == value_of(defaults[i])) continue;
    throw UsageError(
        fmt::format("{} without --criteria; nothing is judged: name a criterion or leave it out",
                    long_flag(rows[i])));
  }
}

void set_if(std::optional<Angle>& value, const std::optional<double>& degrees) {
  if (degrees) value = Angle::degrees(*degrees);
}

void set_if(std::optional<double>& value, const std::optional<double>& given) {
  if (given) value = given;
}

UncertaintyBudget budget_of(const CriteriaChoice& o, const Sonar& sonar) {
  UncertaintyBudget budget;
  use_sonar(sonar.name, budget);
  if (o.positioning != "none") use_positioning(o.positioning, budget);
  if (o.motion_sensor != "none") use_motion_sensor(o.motion_sensor, budget);
  budget.beam_width_along = sonar.beam_width_along;
  set_if(budget.range_m, o.range_m);
  set_if(budget.beam_angle, o.beam_angle_deg);
  budget.mean_sound_speed_mps = o.sound_speed_mps;
  budget.head_sound_speed_mps = o.head_sound_speed_mps;
  set_if(budget.roll, o.roll_deg);
  set_if(budget.pitch, o.pitch_deg);
  set_if(budget.heading, o.heading_deg);
  set_if(budget.heave_m, o.heave_m);
  if (o.heave_share_pct) budget.heave_share = *o.heave_share_pct / 100.0;
  budget.expected_heave_m = o.expected_heave_m;
  set_if(budget.position_m, o.position_m);
  set_if(budget.timing_s, o.timing_s);
  set_if(budget.water_level_m, o.water_level_m);
  budget.draft_m = o.draft_m;
  budget.squat_m = o.squat_m;
  return budget;
}

std::optional<Judging> judging_of(const CriteriaChoice& o, const Sonar& sonar,
                                  double sound_speed_mps) {
  if (o.criterion == "none") {
    refuse_idle(o);
    return std::nullopt;
  }
  Judging judging{&criterion(o.criterion), budget_of(o, sonar), {}, o.require_pass};
  judging.budget.sound_speed_mps = sound_speed_mps;
  judging.how.smooth_seafloor = o.smooth_seafloor;
  // What is missing is refused before any work.
  static_cast<void>(UncertaintyModel(judging.budget));
  return judging;
}

void keep_degrees(std::optional<double>& given, const std::optional<Angle>& in_force) {
  if (!given && in_force) given = tidy_degrees(*in_force);
}

CriteriaChoice in_force(const CriteriaChoice& typed, const UncertaintyBudget& budget) {
  CriteriaChoice o = typed;
  if (!o.range_m) o.range_m = budget.range_m;
  keep_degrees(o.beam_angle_deg, budget.beam_angle);
  keep_degrees(o.roll_deg, budget.roll);
  keep_degrees(o.pitch_deg, budget.pitch);
  keep_degrees(o.heading_deg, budget.heading);
  if (!o.heave_m) o.heave_m = budget.heave_m;
  keep(o.heave_share_pct, 100.0 * budget.heave_share);
  if (!o.position_m) o.position_m = budget.position_m;
  if (!o.timing_s) o.timing_s = budget.timing_s;
  if (!o.water_level_m) o.water_level_m = budget.water_level_m;
  return o;
}

/// 'shoalest', 'mean' or 'p10'.
BlockDepth block_depth(const std::string& text) {
  if (text.empty() || text == "shoalest") return {};
  if (text == "mean") return {.mean = true};
  if (text.starts_with('p') && text.size() > 1) {
    const double share = number(text.substr(1), "--spacing-depth") / 100.0;
    if (share >= 0.0 && share < 1.0) return {.share = share};
  }
  throw UsageError(fmt::format(
      "--spacing-depth {}; must be shoalest, mean, or a percentile from p0 to p99, as p10", text));
}

PlanOptions planning_of(const SurveyOptions& options, const Survey& survey) {
  const PlanningChoice& o = options.planning;
  PlanOptions result;
  result.sonar = survey.sonar;
  result.vehicle = survey.vehicle;
  result.resolution_m = options.scoring.resolution_m;
  result.faces = o.faces == "quad" ? FaceShape::quad : FaceShape::triangle;
  result.face_size = o.face_size;
  result.pings = survey.scoring.pings;
  result.noise = survey.scoring.noise;
  result.threads = options.scoring.threads;
  result.bands = bands(o.depth_bands);
  result.smallest_region_m2 = o.smallest_region_m2;
  result.opening = o.opening == "ping" ? Opening::ping : Opening::region;
  if (o.smooth == "ipopt") result.smooth = smoothing_for(result);
  result.run_in_m = o.run_in_m;
  result.run_out_m = o.run_out_m;
  result.lines = o.lines == "straight" ? LineSource::straight
                 : o.lines == "field"  ? LineSource::field
                                       : LineSource::automatic;
  result.goal.coverage_pct = o.goal_coverage_pct;
  result.goal.length_m = o.goal_length_m;
  if (o.goal_time_h) result.goal.time_s = 3600.0 * *o.goal_time_h;
  if (o.cover == "footprint" && options.scoring.hit_only) {
    throw UsageError(
        "--cover footprint with --hit-only; plans are judged by the footprint score, leave "
        "--hit-only out");
  }
  result.counted = o.counted == "all" ? Counted::all : Counted::logged;
  result.angles = o.angles == "ping" ? Angles::ping : Angles::line;
  result.least_line_m = o.least_line_m.value_or(practical_least_line_m(survey.vehicle));
  result.least_speed_mps = o.least_speed_mps.value_or(0.5 * survey.vehicle.speed_mps);
  if (result.least_speed_mps > survey.vehicle.speed_mps) {
    throw UsageError(
        fmt::format("--least-speed {:g}; must not be above the speed on lines, {:g} m/s",
                    result.least_speed_mps, survey.vehicle.speed_mps));
  }
  set_if(result.soundings, o.soundings);
  result.cover = o.cover == "footprint" ? Cover::footprint : Cover::hit;
  result.lines_margin = o.line_margin_pct / 100.0;
  if (o.swath_by == "footprint" && (o.overlap_pct || !o.spacing_depth.empty())) {
    throw UsageError(fmt::format(
        "--{} with --swath-by footprint; lines lie W = beams x resolution apart there: leave it "
        "out, or add --swath-by fan",
        o.overlap_pct ? "overlap" : "spacing-depth"));
  }
  result.rows.swath_by = o.swath_by == "fan" ? SwathBy::fan : SwathBy::footprint;
  result.rows.spacing_m = o.spacing_m;
  if (o.overlap_pct) result.rows.overlap = *o.overlap_pct / 100.0;
  result.rows.depth = block_depth(o.spacing_depth);
  set_if(result.opening_angle, o.opening_deg);
  check(result);
  return result;
}

}  // namespace

Sonar sonar_of(const SonarChoice& o) {
  const auto preset = sonar_preset(o.preset);
  if (!preset) throw UsageError("sonar", o.preset, "no such preset");
  Sonar sonar = *preset;
  if (o.beams) sonar.beams = *o.beams;
  if (o.max_opening_deg) sonar.max_opening = Angle::degrees(*o.max_opening_deg);
  set_if(sonar.max_ping_rate_hz, o.ping_rate_hz);
  if (o.swaths != "preset") sonar.dual_swath = o.swaths == "dual";
  if (!o.coverage_curve.empty()) sonar.coverage_curve = coverage_curve(o.coverage_curve);
  sonar.spacing =
      o.beam_spacing == "equidistant" ? BeamSpacing::equidistant : BeamSpacing::equiangular;
  return sonar;
}

Vehicle vehicle_of(const VehicleChoice& o) {
  const auto preset = vehicle_preset(o.preset);
  if (!preset) throw UsageError("vehicle", o.preset, "no such preset");
  Vehicle vehicle = *preset;
  set_if(vehicle.draft_m, o.draft_m);
  set_if(vehicle.under_keel_margin_m, o.margin_m);
  set_if(vehicle.squat_m, o.squat_m);
  set_if(vehicle.beam_m, o.beam_m);
  set_if(vehicle.position_error_m, o.position_error_m);
  set_if(vehicle.wall_margin_m, o.wall_margin_m);
  vehicle.clearance_m = o.clearance_m.value_or(practical_clearance_m(vehicle));
  set_if(vehicle.turn_radius_m, o.turn_radius_m);
  set_if(vehicle.speed_mps, o.speed_mps);
  set_if(vehicle.turn_speed_mps, o.turn_speed_mps);
  set_if(vehicle.transit_speed_mps, o.transit_speed_mps);
  set_if(vehicle.endurance_h, o.endurance_h);
  if (o.contingency_pct) vehicle.contingency = *o.contingency_pct / 100.0;
  if (o.power_w) vehicle.power_w = o.power_w;
  return vehicle;
}

// Outlines of gaps with so many corners take some ten megabytes of holidays.geojson.
constexpr std::size_t kOutlineCorners = 400'000;

Survey survey_of(const SurveyOptions& o) {
  Survey survey;
  survey.sonar = sonar_of(o.sonar);
  survey.vehicle = vehicle_of(o.vehicle);
  survey.scoring.resolution_m = o.scoring.resolution_m;
  survey.scoring.pings.spacing_m = o.scoring.ping_spacing_m;
  survey.scoring.pings.sound_speed_mps = o.scoring.sound_speed_mps;
  check(survey.sonar, survey.scoring.pings);
  survey.scoring.holiday_m2 = o.scoring.holiday_m2;
  survey.scoring.nodata = o.scoring.nodata == "open" ? Nodata::open : Nodata::wall;
  survey.scoring.footprint = !o.scoring.hit_only;
  survey.scoring.threads = o.scoring.threads;
  survey.scoring.noise = noise_of(o.noise);
  survey.judging = judging_of(o.criteria, survey.sonar, o.scoring.sound_speed_mps);
  survey.planning = planning_of(o, survey);
  survey.scoring.logged_counts = survey.planning.counted == Counted::logged;
  survey.scoring.outline_corners = kOutlineCorners;
  survey.heading_deg = o.planning.heading_deg;
  survey.asked_soundings = o.planning.soundings;
  survey.asked_ping_rate_hz = o.sonar.ping_rate_hz;
  survey.north = o.planning.north;
  survey.start_text = o.planning.start;
  if (!survey.start_text.empty()) survey.start_xy = start_point(survey.start_text);
  return survey;
}

PlanOptions planning_in(const Survey& survey, const ImportedSeafloor& data) {
  PlanOptions options = survey.planning;
  options.grid_north = Angle::degrees(data.convergence_deg);
  if (survey.heading_deg) options.heading = grid_heading(*survey.heading_deg, survey.north, data);
  if (!survey.start_xy) return options;
  try {
    options.start = local_of(data, *survey.start_xy);
  } catch (const InvalidInput& e) {
    throw UsageError(fmt::format("--start {}: {}", survey.start_text, e.what()));
  }
  return options;
}

Angle grid_heading(double heading_deg, const std::string& north, const ImportedSeafloor& data) {
  return Angle::degrees(north == "grid" ? heading_deg : heading_deg - data.convergence_deg);
}

VehicleChoice in_force(const VehicleChoice& typed, const Vehicle& vehicle) {
  VehicleChoice o = typed;
  keep(o.draft_m, vehicle.draft_m);
  keep(o.margin_m, vehicle.under_keel_margin_m);
  keep(o.squat_m, vehicle.squat_m);
  keep(o.clearance_m, vehicle.clearance_m);
  keep(o.beam_m, vehicle.beam_m);
  keep(o.position_error_m, vehicle.position_error_m);
  keep(o.wall_margin_m, vehicle.wall_margin_m);
  keep(o.turn_radius_m, vehicle.turn_radius_m);
  keep(o.speed_mps, vehicle.speed_mps);
  keep(o.turn_speed_mps, vehicle.turn_speed_mps);
  keep(o.transit_speed_mps, vehicle.transit_speed_mps);
  keep(o.endurance_h, vehicle.endurance_h);
  keep(o.contingency_pct, 100.0 * vehicle.contingency);
  if (!o.power_w) o.power_w = vehicle.power_w;
  return o;
}

SurveyOptions in_force(const SurveyOptions& typed, const Survey& survey) {
  SurveyOptions o = typed;
  if (!o.sonar.beams) o.sonar.beams = survey.sonar.beams;
  keep(o.sonar.max_opening_deg, tidy_degrees(survey.sonar.max_opening));
  keep(o.sonar.ping_rate_hz, survey.sonar.max_ping_rate_hz);
  o.vehicle = in_force(typed.vehicle, survey.vehicle);
  const TrackNoise& noise = survey.scoring.noise;
  keep(o.noise.lateral_sigma_m, noise.lateral_sigma_m);
  keep(o.noise.heading_sigma_deg, tidy_degrees(noise.heading_sigma));
  keep(o.noise.roll_sigma_deg, tidy_degrees(noise.roll_sigma));
  keep(o.noise.heave_sigma_m, noise.heave_sigma_m);
  keep(o.planning.least_line_m, survey.planning.least_line_m);
  keep(o.planning.least_speed_mps, survey.planning.least_speed_mps);
  keep(o.planning.soundings, survey.planning.soundings);
  if (!o.planning.spacing_m) keep(o.planning.overlap_pct, 100.0 * survey.planning.rows.overlap);
  if (o.planning.spacing_depth.empty()) o.planning.spacing_depth = "shoalest";
  if (survey.judging) o.criteria = in_force(typed.criteria, survey.judging->budget);
  keep(o.planning.smallest_region_m2, smallest_region_m2(survey.planning));
  return o;
}

ImportOptions import_options(const SiteOptions& o) {
  ImportOptions result;
  result.crs = o.crs;
  result.water_level_m = o.water_level_m + o.chart_datum_offset_m;
  result.z_positive =
      o.z_positive == "down" ? ImportOptions::ZPositive::down : ImportOptions::ZPositive::up;
  result.up = o.up == "y"   ? ImportOptions::Up::y
              : o.up == "z" ? ImportOptions::Up::z
                            : ImportOptions::Up::ask;
  result.z_unit_m = o.z_unit_m;
  result.xy_unit_m = o.xy_unit_m;
  result.longest_edge_m = o.longest_edge_m;
  result.nodata = o.nodata_value;
  result.columns = o.columns;
  result.layer = fmt::format("{}", fmt::join(o.layers, ","));
  return result;
}

Provenance provenance_of(const std::string& command, const SiteOptions& site,
                         const std::string& input_hash) {
  Provenance provenance;
  provenance.version = SWATHPLAN_VERSION;
  provenance.command = command;
  provenance.input_file = site.file.filename().string();
  provenance.input_hash = input_hash;
  SiteOptions typed = site;
  record(provenance, site_options(typed));
  return provenance;
}

void record(Provenance& provenance, const OptionTable& options) {
  record(provenance, options, options);
}

void record_scoring(Provenance& provenance, const SurveyOptions& typed, const Survey& survey) {
  SurveyOptions as_typed = typed;
  SurveyOptions now = in_force(typed, survey);
  record(provenance, scoring_options(as_typed), scoring_options(now));
  if (survey.judging) {
    record(provenance, criteria_options(as_typed.criteria), criteria_options(now.criteria));
  }
}

void record_planning(Provenance& provenance, const SurveyOptions& typed, const Survey& survey) {
  SurveyOptions as_typed = typed;
  SurveyOptions now = in_force(typed, survey);
  record(provenance, planning_options(as_typed.planning), planning_options(now.planning));
}

}  // namespace swathplan

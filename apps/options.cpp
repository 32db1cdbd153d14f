#include "apps/options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "apps/preset_names.h"
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

double z_unit_m(const std::string& text) {
  if (text == "metre" || text == "meter" || text == "m") return 1.0;
  if (text == "foot" || text == "ft") return 0.3048;
  if (text == "us-foot") return 1200.0 / 3937.0;
  if (text == "fathom") return 1.8288;
  const double value = number(text, "--z-unit");
  if (!(value > 0.0)) {
    throw UsageError(
        fmt::format("--z-unit {}; must be metre, foot, us-foot, fathom or a number "
                    "of metres above 0",
                    text));
  }
  return value;
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

Vec2 start_point(const std::string& text, const Frame& frame) {
  const auto parts = split(text, ',');
  if (parts.size() != 2) {
    throw UsageError(fmt::format(
        "--start '{}'; must be X,Y in the coordinates of the seafloor file, as in '150,20'", text));
  }
  return frame.to_local({number(parts[0], "--start"), number(parts[1], "--start")});
}

template <class T>
void set_if(T& value, const std::optional<double>& given) {
  if (given) value = *given;
}

void require(bool good, const char* option, double value, std::string_view rule) {
  if (!good || !std::isfinite(value)) {
    throw UsageError(fmt::format("{} {:g}; {}", option, value, rule));
  }
}

void require_ping_spacing(double metres) {
  require(metres > 0.0 && metres <= 100.0, "--ping-spacing", metres,
          "must be above 0 and at most 100 metres");
}

}  // namespace

ImportOptions import_options(const SiteOptions& o) {
  ImportOptions result;
  result.crs = o.crs;
  result.water_level_m = o.water_level;
  result.z_positive =
      o.z_positive == "down" ? ImportOptions::ZPositive::down : ImportOptions::ZPositive::up;
  result.z_unit_m = z_unit_m(o.z_unit);
  result.xy_unit_m = o.xy_unit_m;
  result.longest_edge_m = o.longest_edge_m;
  result.nodata = o.nodata_value;
  return result;
}

Sonar sonar_of(const SurveyOptions& o) {
  const auto preset = sonar_preset(o.sonar);
  if (!preset) {
    throw UsageError(fmt::format("--sonar {}: no such preset; choose one of {}", o.sonar,
                                 names(sonar_presets())));
  }
  Sonar sonar = *preset;
  if (o.beams) sonar.beams = *o.beams;
  if (sonar.beams < 2 || sonar.beams > 100000) {
    throw UsageError(fmt::format("--beams {}; must be 2 to 100000", sonar.beams));
  }
  if (o.max_opening_deg) {
    require(*o.max_opening_deg > 0.0 && *o.max_opening_deg < 180.0, "--max-opening",
            *o.max_opening_deg,
            "must lie between 0 and 180 degrees, both excluded: a beam at 90 "
            "degrees from nadir never meets the seafloor");
    sonar.max_opening = Angle::degrees(*o.max_opening_deg);
  }
  sonar.spacing =
      o.beam_spacing == "equidistant" ? BeamSpacing::equidistant : BeamSpacing::equiangular;
  return sonar;
}

Vehicle vehicle_of(const SurveyOptions& o) {
  const auto preset = vehicle_preset(o.vehicle);
  if (!preset) {
    throw UsageError(fmt::format("--vehicle {}: no such preset; choose one of {}", o.vehicle,
                                 names(vehicle_presets())));
  }
  Vehicle vehicle = *preset;
  set_if(vehicle.draft_m, o.draft_m);
  set_if(vehicle.under_keel_margin_m, o.margin_m);
  set_if(vehicle.squat_m, o.squat_m);
  set_if(vehicle.clearance_m, o.clearance_m);
  set_if(vehicle.turn_radius_m, o.turn_radius_m);
  set_if(vehicle.speed_mps, o.speed_mps);
  set_if(vehicle.turn_speed_mps, o.turn_speed_mps);
  set_if(vehicle.transit_speed_mps, o.transit_speed_mps);
  set_if(vehicle.endurance_h, o.endurance_h);
  if (o.contingency_pct) vehicle.contingency = *o.contingency_pct / 100.0;
  if (o.power_w) vehicle.power_w = o.power_w;
  require(vehicle.draft_m >= 0.0, "--draft", vehicle.draft_m, "must be 0 metres or more");
  require(vehicle.under_keel_margin_m >= 0.0, "--margin", vehicle.under_keel_margin_m,
          "must be 0 metres or more");
  require(vehicle.squat_m >= 0.0, "--squat", vehicle.squat_m, "must be 0 metres or more");
  require(vehicle.clearance_m >= 0.0, "--clearance", vehicle.clearance_m,
          "must be 0 metres or more");
  require(vehicle.turn_radius_m > 0.0, "--turn-radius", vehicle.turn_radius_m,
          "must be above 0 metres");
  require(vehicle.speed_mps > 0.0, "--speed", vehicle.speed_mps, "must be above 0 m/s");
  require(vehicle.turn_speed_mps > 0.0, "--turn-speed", vehicle.turn_speed_mps,
          "must be above 0 m/s");
  require(vehicle.transit_speed_mps > 0.0, "--transit-speed", vehicle.transit_speed_mps,
          "must be above 0 m/s");
  require(vehicle.endurance_h > 0.0, "--endurance", vehicle.endurance_h, "must be above 0 hours");
  if (o.contingency_pct) {
    require(*o.contingency_pct >= 0.0, "--contingency", *o.contingency_pct,
            "must be 0 per cent or more");
  }
  if (o.power_w) require(*o.power_w > 0.0, "--power", *o.power_w, "must be above 0 watts");
  return vehicle;
}

namespace {

TrackNoise noise_of(const SurveyOptions& o) {
  TrackNoise noise;
  noise.seed = o.seed;
  if (o.noise == "calm" || o.noise == "rough") {
    const bool calm = o.noise == "calm";
    noise.lateral_sigma_m = calm ? 0.3 : 1.0;
    noise.heading_sigma = Angle::degrees(calm ? 2.0 : 4.0);
  }
  set_if(noise.lateral_sigma_m, o.lateral_sigma_m);
  set_if(noise.heave_sigma_m, o.heave_sigma_m);
  if (o.heading_sigma_deg) noise.heading_sigma = Angle::degrees(*o.heading_sigma_deg);
  if (o.roll_sigma_deg) noise.roll_sigma = Angle::degrees(*o.roll_sigma_deg);
  const auto sigma = [](const char* option, double value) {
    require(value >= 0.0, option, value, "must be 0 or more");
  };
  sigma("--lateral-sigma", noise.lateral_sigma_m);
  sigma("--heading-sigma", noise.heading_sigma.deg());
  sigma("--roll-sigma", noise.roll_sigma.deg());
  sigma("--heave-sigma", noise.heave_sigma_m);
  return noise;
}

}  // namespace

PlanOptions plan_options(const SurveyOptions& o, const Frame& frame) {
  PlanOptions result;
  result.sonar = sonar_of(o);
  result.vehicle = vehicle_of(o);
  require(o.resolution_m > 0.0, "--resolution", o.resolution_m, "must be above 0 metres");
  result.resolution_m = o.resolution_m;
  if (o.face_size) require(*o.face_size > 0.0, "--face-size", *o.face_size, "must be above 0");
  result.faces = o.faces == "quad" ? FaceShape::quad : FaceShape::triangle;
  result.face_size = o.face_size;
  require_ping_spacing(o.ping_spacing_m);
  result.ping_spacing_m = o.ping_spacing_m;
  result.threads = o.threads;
  result.bands = bands(o.depth_bands);
  result.smallest_region_m2 = o.smallest_region_m2;
  result.opening = o.opening == "ping" ? Opening::ping : Opening::region;
  require(true, "--run-in", o.run_in_m, "must be a number of metres");
  require(true, "--run-out", o.run_out_m, "must be a number of metres");
  result.run_in_m = o.run_in_m;
  if (o.smooth == "ipopt") result.smooth = smoothing_for(result);
  result.run_out_m = o.run_out_m;
  if (!o.start.empty()) result.start = start_point(o.start, frame);
  if (o.heading_deg) {
    require(*o.heading_deg >= 0.0 && *o.heading_deg < 360.0, "--heading", *o.heading_deg,
            "must be at least 0 and under 360 degrees");
    result.heading = Angle::degrees(*o.heading_deg);
  }
  result.lines = o.lines == "straight" ? LineSource::straight
                 : o.lines == "field"  ? LineSource::field
                                       : LineSource::automatic;
  if (o.goal_coverage_pct) {
    require(*o.goal_coverage_pct > 0.0 && *o.goal_coverage_pct <= 100.0, "--coverage",
            *o.goal_coverage_pct, "must be above 0 and at most 100 per cent");
  }
  if (o.goal_length_m)
    require(*o.goal_length_m > 0.0, "--length", *o.goal_length_m, "must be above 0");
  if (o.goal_time_h) require(*o.goal_time_h > 0.0, "--time", *o.goal_time_h, "must be above 0");
  result.goal.coverage_pct = o.goal_coverage_pct;
  result.goal.length_m = o.goal_length_m;
  if (o.goal_time_h) result.goal.time_s = 3600.0 * *o.goal_time_h;
  if (o.cover == "footprint" && o.hit_only) {
    throw UsageError(
        "--cover footprint with --hit-only; plans are judged by the footprint score, leave "
        "--hit-only out");
  }
  result.cover = o.cover == "footprint" ? Cover::footprint : Cover::hit;
  require(o.line_margin_pct >= 0.0 && o.line_margin_pct <= 100.0 * kMostMargin, "--line-margin",
          o.line_margin_pct, fmt::format("must be 0 to {:g} per cent", 100.0 * kMostMargin));
  result.lines_margin = o.line_margin_pct / 100.0;
  result.noise = noise_of(o);
  return result;
}

ScoreOptions score_options(const SurveyOptions& o) {
  ScoreOptions result;
  require(o.resolution_m > 0.0, "--resolution", o.resolution_m, "must be above 0 metres");
  require_ping_spacing(o.ping_spacing_m);
  require(o.holiday_m2 >= 0.0, "--holiday", o.holiday_m2, "must be 0 square metres or more");
  if (o.threads < 0) throw UsageError(fmt::format("--threads {}; must be 0 or more", o.threads));
  result.resolution_m = o.resolution_m;
  result.ping_spacing_m = o.ping_spacing_m;
  result.holiday_m2 = o.holiday_m2;
  result.nodata = o.nodata == "open" ? Nodata::open : Nodata::wall;
  result.footprint = !o.hit_only;
  result.threads = o.threads;
  result.noise = noise_of(o);
  return result;
}

Provenance provenance_of(const std::string& command, const SiteOptions& site,
                         const SurveyOptions& o, const std::string& input_hash) {
  Provenance p;
  p.version = SWATHPLAN_VERSION;
  p.command = command;
  p.input_file = site.file.filename().string();
  p.input_hash = input_hash;
  p.seed = o.seed;
  const Vehicle vehicle = vehicle_of(o);
  const Sonar sonar = sonar_of(o);
  const ScoreOptions score = score_options(o);
  const auto add = [&](const char* name, OptionValue value) {
    p.options.emplace_back(name, std::move(value));
  };
  const auto file = [](const std::filesystem::path& path) { return path.filename().string(); };
  add("crs", site.crs);
  add("water_level_m", site.water_level);
  add("z_positive", site.z_positive);
  add("z_unit_m", z_unit_m(site.z_unit));
  add("area_file", file(site.area));
  add("no_go_file", file(site.no_go));
  add("run_out_margin_m", site.run_out_margin_m);
  add("resolution_m", o.resolution_m);
  add("ping_spacing_m", o.ping_spacing_m);
  add("sonar", sonar.name);
  add("beams", static_cast<std::int64_t>(sonar.beams));
  add("beam_spacing", o.beam_spacing);
  add("max_opening_deg", tidy_degrees(sonar.max_opening));
  add("vehicle", vehicle.name);
  add("draft_m", vehicle.draft_m);
  add("under_keel_margin_m", vehicle.under_keel_margin_m);
  add("squat_m", vehicle.squat_m);
  add("clearance_m", vehicle.clearance_m);
  add("turn_radius_m", vehicle.turn_radius_m);
  add("speed_mps", vehicle.speed_mps);
  add("turn_speed_mps", vehicle.turn_speed_mps);
  add("transit_speed_mps", vehicle.transit_speed_mps);
  add("endurance_h", vehicle.endurance_h);
  add("contingency_pct", o.contingency_pct.value_or(100.0 * vehicle.contingency));
  if (vehicle.power_w) add("power_w", *vehicle.power_w);
  add("nodata", o.nodata);
  add("lateral_sigma_m", score.noise.lateral_sigma_m);
  add("heading_sigma_deg", tidy_degrees(score.noise.heading_sigma));
  add("roll_sigma_deg", tidy_degrees(score.noise.roll_sigma));
  add("heave_sigma_m", score.noise.heave_sigma_m);
  add("holiday_m2", o.holiday_m2);
  if (command != "score") {
    add("depth_bands", o.depth_bands);
    add("smallest_region_m2", smallest_region_m2(plan_options(o, Frame{})));
    add("faces", o.faces);
    if (o.face_size) add("face_size", *o.face_size);
    add("opening", o.opening);
    add("smooth", o.smooth);
    add("run_in_m", o.run_in_m);
    add("run_out_m", o.run_out_m);
    add("start", o.start);
    if (o.heading_deg) add("heading_deg", *o.heading_deg);
    add("lines", o.lines);
    if (o.goal_coverage_pct) add("goal_coverage_pct", *o.goal_coverage_pct);
    if (o.goal_length_m) add("goal_length_m", *o.goal_length_m);
    if (o.goal_time_h) add("goal_time_h", *o.goal_time_h);
    add("cover", o.cover);
    add("line_margin_pct", o.line_margin_pct);
  }
  return p;
}

}  // namespace swathplan

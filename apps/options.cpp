#include "apps/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "apps/profiles.h"
#include "coverage/route/sonar.h"
#include "coverage/route/vehicle.h"
#include "coverage/standards/criteria.h"
#include "coverage/standards/uncertainty.h"
#include "io/exports/route_export.h"
#include "mesh/base/error.h"
#include "planners/plan.h"

namespace swathplan {
namespace {

const char* const kSeafloorGroup = "Seafloor";
const char* const kHazardGroup = "Charts and hazards";
const char* const kWaterGroup = "Water";
const char* const kCoveredGroup = "Already covered";
const char* const kScoringGroup = "Scoring";
const char* const kSonarGroup = "Sonar";
const char* const kVehicleGroup = "Vehicle";
const char* const kNoiseGroup = "Tracking errors";
const char* const kCriteriaGroup = "Criteria";
const char* const kUncertaintyGroup = "Uncertainty (one standard deviation each)";
const char* const kPlanningGroup = "Planning";
const char* const kSpacingGroup = "Line spacing";

template <class Presets>
std::vector<std::string> names_of(const Presets& presets, std::vector<std::string> names = {}) {
  names.reserve(names.size() + presets.size());
  for (const auto& preset : presets) names.emplace_back(preset.name);
  return names;
}

/// The rows of the sets that several commands share; their fields are what errors can name.
const OptionTable& shared_options() {
  static SiteOptions site;
  static SurveyOptions survey;
  static ExportChoice exports;
  static JobChoice job;
  static CoveredChoice covered;
  static WaterChoice water;
  static const OptionTable table =
      joined({site_options(site), covered_options(covered), water_options(water),
              scoring_options(survey), criteria_options(survey.criteria),
              planning_options(survey.planning), job_options(job), exporting_options(exports)});
  return table;
}

/// The flag of a field in any spelling, as 'CRS'; the field itself if it is none.
std::string flag_of(const std::string& field) {
  std::string low = field;
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Option& option : shared_options()) {
    if (!is_argument(option) && field_of(option) == low) return long_flag(option);
  }
  return field;
}

/// Whether the text between brackets can be the name of an option.
bool is_field(const std::string& text) {
  return !text.empty() && text.size() < 40 && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == ' ' || c == '-';
  });
}

}  // namespace

OptionTable site_options(SiteOptions& o, bool with_file) {
  Option file = argument("FILE", o.file, "Seafloor: mesh, grid or soundings");
  file.required = with_file;
  Option z_unit =
      real("--z-unit", kSeafloorGroup, o.z_unit_m, kMetres, above(0.0),
           "Unit of z: metre, foot, us-foot, fathom or metres in one unit (default: what "
           "the file says, else metres)",
           "z_unit_m");
  z_unit.words = {{"metre", 1.0},    {"meter", 1.0}, {"m", 1.0},
                  {"foot", 0.3048},  {"ft", 0.3048}, {"us-foot", 1200.0 / 3937.0},
                  {"fathom", 1.8288}};
  return {
      file,
      text("--crs", kSeafloorGroup, o.crs, "CRS of FILE, as EPSG:n or WKT, where it does not say",
           "crs"),
      real("--water-level", kSeafloorGroup, o.water_level_m, kMetres, any_number(),
           "Height of still water in FILE's datum, metres", "water_level_m"),
      real("--chart-datum-offset", kSeafloorGroup, o.chart_datum_offset_m, kMetres, any_number(),
           "Height of chart datum in FILE's datum, metres; --water-level and --tide count from "
           "chart datum",
           "chart_datum_offset_m"),
      choice("--z-positive", kSeafloorGroup, o.z_positive, {"up", "down"},
             "Which way z counts in FILE", "z_positive"),
      choice("--up", kSeafloorGroup, o.up, {"ask", "y", "z"},
             "Axis of a mesh that points up; ask: z, and meshes that look y up are refused", "up"),
      z_unit,
      real("--xy-unit", kSeafloorGroup, o.xy_unit_m, kMetres, above(0.0),
           "Metres in one horizontal unit, where the CRS does not say", "xy_unit_m"),
      real(
          "--longest-edge", kSeafloorGroup, o.longest_edge_m, kMetres, above(0.0),
          "Soundings: leave out triangles with a longer edge, metres (default: from their spacing)",
          "longest_edge_m"),
      text("--columns", kSeafloorGroup, o.columns,
           "Soundings: which columns are meant, by number or name, as x=3,y=2,z=5 or "
           "lon=2,lat=1,depth=DEPTH (default: from their names)",
           "columns"),
      real("--nodata-value", kSeafloorGroup, o.nodata_value, kNoUnit, any_number(),
           "A further z that means 'no data'", "nodata_value"),
      path("--area", kSeafloorGroup, o.area,
           "Survey only inside these polygons (GeoJSON, GeoPackage, ...)", "area_file"),
      path("--no-go", kSeafloorGroup, o.no_go, "Never enter these polygons", "no_go_file"),
      texts("--layer", kSeafloorGroup, o.layers,
            "Layers or variables of FILE and of these files that are meant, separated by commas "
            "(default: the only one)",
            "layers"),
      real("--buffer", kSeafloorGroup, o.buffer_m, kMetres, at_least(0.0),
           "Lines and points of these files count with so much room around, metres; 0: not at all",
           "buffer_m"),
      real("--run-out-margin", kSeafloorGroup, o.run_out_margin_m, kMetres, at_least(0.0),
           "The boat may turn so far beyond the data's outer edge, metres; only where no land is",
           "run_out_margin_m"),
      texts("--mosaic", kSeafloorGroup, o.mosaic,
            "More files of the same seafloor, separated by commas or blanks: joined with FILE",
            "mosaic_files"),
      choice("--priority", kSeafloorGroup, o.priority, {"finest", "newest", "order"},
             "Which file of a mosaic counts where several have data: that of the finest spacing, "
             "the newest date (in the file or in its name), or the one that is named first",
             "priority"),
      texts("--hazards", kHazardGroup, o.hazards,
            "What to keep off, and how far: FILE (a chart), FILE:LAYER=METRES, or of a chart that "
            "is the seafloor LAYER=METRES, LAYER=off, or none; several, separated by commas "
            "(default: the chart's own, with a buffer that grows with the stated accuracy)",
            "hazards"),
      path("--keep-off", kHazardGroup, o.keep_off,
           "Do not sail over these polygons, or within --buffer of these lines and points, but see "
           "them: their cells count in the coverage",
           "keep_off_file"),
      real("--chart-margin", kHazardGroup, o.chart_margin_m, kMetres, at_least(0.0),
           "So much of a chart around the --area is used, metres", "chart_margin_m"),
  };
}

OptionTable water_options(WaterChoice& o) {
  return {
      path("--tide", kWaterGroup, o.tide,
           "Times and heights of the tide (CSV; UTC, metres above chart datum): what it leaves "
           "under the keel of each leg, and when a leg has water enough",
           "tide_file"),
      text("--depart", kWaterGroup, o.depart,
           "When the plan begins, as 2026-05-01T06:30 (UTC, or with +02:00)", "depart"),
  };
}

OptionTable covered_options(CoveredChoice& o) {
  OptionTable table{
      texts("--covered", kCoveredGroup, o.files,
            "What was surveyed before, which is not planned again: rasters of soundings a cell or "
            "of depths, soundings, polygons, tracks; several separated by commas, or given one by "
            "one",
            "covered_files"),
      real("--covered-swath", kCoveredGroup, o.swath_m, kMetres, above(0.0),
           "Tracks without angles covered a strip so wide, metres", "covered_swath_m"),
      real("--covered-opening", kCoveredGroup, o.opening_deg, kDegrees, between(0.0, 180.0),
           "... or what the sonar sees with this full opening angle, degrees",
           "covered_opening_deg"),
  };
  table[1].excludes = {"--covered-opening"};
  return table;
}

namespace {

OptionTable sonar_options(SonarChoice& o) {
  return {
      choice("--sonar", kSonarGroup, o.preset, names_of(sonar_presets()), "Sonar preset", "sonar"),
      whole("--beams", kSonarGroup, o.beams, within(2.0, 100000.0),
            "Beams in a fan (default: the preset's)", "beams"),
      choice("--beam-spacing", kSonarGroup, o.beam_spacing, {"equiangular", "equidistant"},
             "How beams are spread over the fan", "beam_spacing"),
      real("--max-opening", kSonarGroup, o.max_opening_deg, kDegrees,
           between(0.0, 180.0, "a beam at 90 degrees from nadir never meets the seafloor"),
           "Largest full opening angle, degrees (default: the preset's)", "max_opening_deg"),
      real("--ping-rate", kSonarGroup, o.ping_rate_hz, kHertz, above_at_most(0.0, 1000.0),
           "Largest ping rate, Hz (default: the preset's)", "ping_rate_hz"),
      choice("--swaths", kSonarGroup, o.swaths, {"preset", "single", "dual"},
             "Fans in a ping's cycle", "swaths"),
      text("--coverage-curve", kSonarGroup, o.coverage_curve,
           "Half-angles that the fan still sees at depths below the sonar, as 20:65,100:60,250:30 "
           "(metres:degrees; default: as far as the sonar's range goes)",
           "coverage_curve"),
  };
}

OptionTable noise_options(NoiseChoice& o) {
  return {
      choice("--noise", kNoiseGroup, o.preset, {"none", "calm", "rough"},
             "Tracking errors: none, calm (0.3 m, 2 deg) or rough (1 m, 4 deg); plans are judged "
             "with them",
             "noise"),
      real("--lateral-sigma", kNoiseGroup, o.lateral_sigma_m, kMetres, at_least(0.0),
           "Cross-track error, metres (default: the preset's)", "lateral_sigma_m"),
      real("--heading-sigma", kNoiseGroup, o.heading_sigma_deg, kDegrees, at_least(0.0),
           "Heading error, degrees (default: the preset's)", "heading_sigma_deg"),
      real("--roll-sigma", kNoiseGroup, o.roll_sigma_deg, kDegrees, at_least(0.0),
           "Roll that is not compensated, degrees (default: 0)", "roll_sigma_deg"),
      real("--heave-sigma", kNoiseGroup, o.heave_sigma_m, kMetres, at_least(0.0),
           "Heave, metres (default: 0)", "heave_sigma_m"),
      whole("--seed", kNoiseGroup, o.seed, "Seed of the tracking errors", "seed"),
  };
}

}  // namespace

Option profile_option(std::string& profile) {
  std::vector<std::string> names;
  std::string help = "What is taken where nothing is given;";
  for (const Profile& p : kProfiles) {
    names.emplace_back(p.name);
    help += fmt::format(" {}: {} (", p.name, p.what);
    for (const ProfileRow& row : p.rows) {
      help += fmt::format("{}{} = {}", &row == p.rows.data() ? "" : ", ", row.name, row.value);
    }
    help += ");";
  }
  help.back() = '.';
  help += " A file of such lines for --config is a profile of your own";
  return choice("--profile", "Profile", profile, names, help, "profile");
}

OptionTable vehicle_options(VehicleChoice& o) {
  return {
      choice("--vehicle", kVehicleGroup, o.preset, names_of(vehicle_presets()),
             "Vehicle preset, which gives the defaults of what follows", "vehicle"),
      real("--draft", kVehicleGroup, o.draft_m, kMetres, at_least(0.0),
           "Draft and depth of the sonar, metres", "draft_m"),
      real("--margin", kVehicleGroup, o.margin_m, kMetres, at_least(0.0),
           "Water wanted below the keel, metres", "under_keel_margin_m"),
      real("--squat", kVehicleGroup, o.squat_m, kMetres, at_least(0.0),
           "Deeper by this under way, metres", "squat_m"),
      real("--clearance", kVehicleGroup, o.clearance_m, kMetres, at_least(0.0),
           "Kept from walls, shoals and no-go areas, metres (default: half the beam, the position "
           "error and the margin to walls)",
           "clearance_m"),
      real("--beam", kVehicleGroup, o.beam_m, kMetres, at_least(0.0), "Width of the hull, metres",
           "beam_m"),
      real("--position-error", kVehicleGroup, o.position_error_m, kMetres, at_least(0.0),
           "How far off its line the boat may be, metres", "position_error_m"),
      real("--wall-margin", kVehicleGroup, o.wall_margin_m, kMetres, at_least(0.0),
           "Room wanted between hull and wall, metres", "wall_margin_m"),
      real("--turn-radius", kVehicleGroup, o.turn_radius_m, kMetres, above(0.0),
           "Smallest turn radius, metres", "turn_radius_m"),
      real("--speed", kVehicleGroup, o.speed_mps, kMetresPerSecond, above(0.0),
           "Speed on lines, m/s, or as 4kn or 7.4km/h", "speed_mps"),
      real("--turn-speed", kVehicleGroup, o.turn_speed_mps, kMetresPerSecond, above(0.0),
           "Speed in turns between lines, m/s", "turn_speed_mps"),
      real("--transit-speed", kVehicleGroup, o.transit_speed_mps, kMetresPerSecond, above(0.0),
           "Speed between areas, m/s", "transit_speed_mps"),
      real("--endurance", kVehicleGroup, o.endurance_h, kHours, above(0.0),
           "Longest time under way, hours", "endurance_h"),
      real("--contingency", kVehicleGroup, o.contingency_pct, kPerCent, at_least(0.0),
           "Allowance for what goes wrong, per cent of the duration (default: 10)",
           "contingency_pct"),
      real("--power", kVehicleGroup, o.power_w, kWatts, above(0.0), "Mean power under way, watts",
           "power_w"),
  };
}

OptionTable scoring_options(SurveyOptions& survey) {
  ScoringChoice& o = survey.scoring;
  const OptionTable cells{
      real("--resolution", kScoringGroup, o.resolution_m, kMetres, above(0.0),
           "Side of a scoring cell, metres (charts: 1)", "resolution_m"),
      real(
          "--ping-spacing", kScoringGroup, o.ping_spacing_m, kMetres, above_at_most(0.0, 100.0),
          "One ping each so many metres of path (default: by the clock, as fast as sonar and sound "
          "allow)",
          "ping_spacing_m"),
      real("--sound-speed", kScoringGroup, o.sound_speed_mps, kMetresPerSecond, within(1300, 1700),
           "Speed of sound in the water, m/s", "sound_speed_mps"),
  };
  const OptionTable beyond{
      choice("--nodata", kScoringGroup, o.nodata, {"wall", "open"},
             "What beams meet beyond the data", "nodata"),
  };
  const OptionTable rest{
      real("--holiday", kScoringGroup, o.holiday_m2, kSquareMetres, at_least(0.0),
           "List holidays of at least this, square metres", "holiday_m2"),
      flag("--hit-only", kScoringGroup, o.hit_only, "Leave out the footprint score (faster)",
           "hit_only"),
      whole("--threads", kScoringGroup, o.threads, at_least(0.0),
            "Threads; 0: all cores (results do not depend on it)", ""),
  };
  return joined({{profile_option(survey.profile)},
                 cells,
                 sonar_options(survey.sonar),
                 vehicle_options(survey.vehicle),
                 beyond,
                 noise_options(survey.noise),
                 rest});
}

namespace {

OptionTable sounding_uncertainties(CriteriaChoice& o) {
  const char* const group = kUncertaintyGroup;
  return {
      real("--range-uncertainty", group, o.range_m, kMetres, at_least(0.0),
           "Slant range, metres (default: the sonar's)", "range_uncertainty_m"),
      real("--beam-angle-uncertainty", group, o.beam_angle_deg, kDegrees, at_least(0.0),
           "Beam angle, degrees (default: the sonar's)", "beam_angle_uncertainty_deg"),
      real("--sound-speed-uncertainty", group, o.sound_speed_mps, kMetresPerSecond, at_least(0.0),
           "Mean sound speed of the water, m/s", "sound_speed_uncertainty_mps"),
      real("--head-sound-speed-uncertainty", group, o.head_sound_speed_mps, kMetresPerSecond,
           at_least(0.0), "Sound speed at the sonar head, m/s", "head_sound_speed_uncertainty_mps"),
  };
}

OptionTable motion_uncertainties(CriteriaChoice& o) {
  const char* const group = kUncertaintyGroup;
  return {
      real("--roll-uncertainty", group, o.roll_deg, kDegrees, at_least(0.0),
           "Roll, degrees (default: the motion sensor's)", "roll_uncertainty_deg"),
      real("--pitch-uncertainty", group, o.pitch_deg, kDegrees, at_least(0.0),
           "Pitch, degrees (default: the motion sensor's)", "pitch_uncertainty_deg"),
      real("--heading-uncertainty", group, o.heading_deg, kDegrees, at_least(0.0),
           "Heading, degrees (default: the motion sensor's)", "heading_uncertainty_deg"),
      real("--heave-uncertainty", group, o.heave_m, kMetres, at_least(0.0),
           "Heave, fixed part, metres (default: the motion sensor's)", "heave_uncertainty_m"),
      real("--heave-share", group, o.heave_share_pct, kPerCent, at_least(0.0),
           "... or per cent of the expected heave, if that is more (default: the motion sensor's)",
           "heave_uncertainty_pct"),
      real("--expected-heave", group, o.expected_heave_m, kMetres, at_least(0.0),
           "Heave that the sea is expected to give, metres", "expected_heave_m"),
  };
}

OptionTable place_uncertainties(CriteriaChoice& o) {
  const char* const group = kUncertaintyGroup;
  return {
      real("--position-uncertainty", group, o.position_m, kMetres, at_least(0.0),
           "Position, in each direction, metres (default: the positioning's)",
           "position_uncertainty_m"),
      real("--timing-uncertainty", group, o.timing_s, "seconds", at_least(0.0),
           "Time between position and ping, seconds (default: the positioning's)",
           "timing_uncertainty_s"),
      real("--draft-uncertainty", group, o.draft_m, kMetres, at_least(0.0), "Draft, metres",
           "draft_uncertainty_m"),
      real("--squat-uncertainty", group, o.squat_m, kMetres, at_least(0.0), "Squat, metres",
           "squat_uncertainty_m"),
      real("--water-level-uncertainty", group, o.water_level_m, kMetres, at_least(0.0),
           "Tide, or height and separation model, metres (default: the positioning's, where that "
           "gives heights)",
           "water_level_uncertainty_m"),
  };
}

}  // namespace

OptionTable criteria_options(CriteriaChoice& o) {
  const OptionTable what{
      choice("--criteria", kCriteriaGroup, o.criterion, names_of(criteria(), {"none"}),
             "Judge the survey's logged lines by this standard", "criteria"),
      flag("--require-pass", kCriteriaGroup, o.require_pass,
           "Exit with 3 if it is predicted to fail", ""),
      flag("--smooth-seafloor", kCriteriaGroup, o.smooth_seafloor,
           "The ground between the points of FILE is known to be smooth: judge it on finer cells "
           "than they show",
           "smooth_seafloor"),
  };
  const OptionTable sensors{
      choice("--positioning", kUncertaintyGroup, o.positioning,
             names_of(positioning_presets(), {"none"}),
             "Positioning preset, which gives position, timing and, with heights, water level",
             "positioning"),
      choice("--motion-sensor", kUncertaintyGroup, o.motion_sensor,
             names_of(motion_sensor_presets(), {"none"}),
             "Motion sensor preset, which gives roll, pitch, heading and heave", "motion_sensor"),
  };
  return joined(
      {what, sensors, sounding_uncertainties(o), motion_uncertainties(o), place_uncertainties(o)});
}

Option swath_option(const std::string& group, std::string& swath_by) {
  return choice("--swath-by", group, swath_by, {"fan", "footprint"},
                "A line's swath is what the fan sweeps at the depth below, or W = beams x "
                "resolution as in the papers",
                "swath_by");
}

namespace {

/// A row that not every planner uses, and those that do.
struct Usage {
  std::string_view flag, planners;
};
constexpr std::array kUsedBy{
    Usage{"--depth-bands", "multi-depth mdnuc"},
    Usage{"--smallest-region", "multi-depth mdnuc"},
    Usage{"--faces", "multi-depth nuc mdnuc"},
    Usage{"--face-size", "multi-depth nuc mdnuc"},
    Usage{"--opening", "back-and-forth multi-depth nuc mdnuc"},
    Usage{"--heading", "back-and-forth multi-depth fitted-lines"},
    Usage{"--north", "back-and-forth multi-depth fitted-lines"},
    Usage{"--lines", "fitted-lines"},
    Usage{"--coverage", "fitted-lines"},
    Usage{"--length", "fitted-lines"},
    Usage{"--time", "fitted-lines"},
    Usage{"--cover", "edge-following fitted-lines"},
    Usage{"--counted", "back-and-forth edge-following nuc mdnuc fitted-lines"},
    Usage{"--angles", "back-and-forth edge-following multi-depth fitted-lines"},
    Usage{"--least-line", "back-and-forth edge-following multi-depth fitted-lines"},
    Usage{"--line-margin", "edge-following fitted-lines"},
    Usage{"--spacing", "back-and-forth multi-depth"},
    Usage{"--overlap", "back-and-forth multi-depth"},
    Usage{"--spacing-depth", "back-and-forth multi-depth"},
};

std::vector<std::string> names_in(std::string_view words) {
  std::vector<std::string> names;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    names.emplace_back(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return names;
}

OptionTable spacing_options(PlanningChoice& o) {
  const char* const group = kSpacingGroup;
  OptionTable table{
      real("--spacing", group, o.spacing_m, kMetres, above(0.0),
           "Metres between lines, those of --beside too (default: by depth, fan and overlap)",
           "spacing_m"),
      real("--overlap", group, o.overlap_pct, kPerCent, at_least_under(0.0, 100.0),
           "Per cent of its swath that a line shares with its neighbour (default: 10)",
           "overlap_pct"),
      text("--spacing-depth", group, o.spacing_depth,
           "Depth of a block that its lines are spaced by: shoalest, mean, or p10 for the one that "
           "10 per cent of the block do not reach (default: shoalest)",
           "spacing_depth"),
      real("--opening-angle", group, o.opening_deg, kDegrees,
           between(0.0, 180.0, "a beam at 90 degrees from nadir never meets the seafloor"),
           "Full fan of every line, degrees (default: as wide as --max-opening and range allow; "
           "fitted lines: what serves best)",
           "opening_angle_deg"),
      swath_option(group, o.swath_by),
  };
  for (Option& option : table) {
    if (option.flag == "--spacing") option.excludes = {"--overlap"};
  }
  return table;
}

}  // namespace

OptionTable planning_options(PlanningChoice& o) {
  OptionTable table{
      text("--depth-bands", kPlanningGroup, o.depth_bands,
           "Depth bands: a number of equal ones, or the depths between them (10,20)",
           "depth_bands"),
      real("--smallest-region", kPlanningGroup, o.smallest_region_m2, kSquareMetres, at_least(0.0),
           "Depth regions under this join a neighbour, square metres (default: 0.3 of a face's "
           "size squared)",
           "smallest_region_m2"),
      choice("--faces", kPlanningGroup, o.faces, {"triangle", "quad"},
             "NUC, MDNUC: the mesh is made of right isosceles triangles or of right-angled quads, "
             "cut to the outline along the boundary",
             "faces"),
      real("--face-size", kPlanningGroup, o.face_size, kNoUnit, above(0.0),
           "Hypotenuse of a triangle or side of a quad, as a share of W (default: 0.93, quads "
           "0.75; the best of several meshes where the area holds few faces)",
           "face_size"),
      choice("--opening", kPlanningGroup, o.opening, {"region", "ping"},
             "Opening angle by depth region, or by ping from the depth below", "opening"),
      choice("--smooth", kPlanningGroup, o.smooth, {"none", "ipopt"},
             "none (arcs and straights) or ipopt: smooth the joins between lines, so that "
             "curvature changes gradually, and the skeleton's path of NUC and MDNUC",
             "smooth"),
      real("--run-in", kPlanningGroup, o.run_in_m, kMetres, any_number(),
           "Sail this far straight before each line, metres; less than 0 shortens the line",
           "run_in_m"),
      real("--run-out", kPlanningGroup, o.run_out_m, kMetres, any_number(),
           "... and behind each line, metres", "run_out_m"),
      text("--start", kPlanningGroup, o.start,
           "Begin near X,Y (coordinates of FILE; where these are degrees, longitude,latitude)",
           "start"),
      real("--heading", kPlanningGroup, o.heading_deg, kDegrees, at_least_under(0.0, 360.0),
           "Azimuth of straight lines, degrees (default: the one with the fewest lines)",
           "heading_deg"),
      north_option(kPlanningGroup, o.north),
      choice("--lines", kPlanningGroup, o.lines, {"straight", "field", "auto"},
             "fitted-lines: straight lines, field lines along fronts from long walls, or both "
             "tried",
             "lines"),
      real("--coverage", kPlanningGroup, o.goal_coverage_pct, kPerCent, above_at_most(0.0, 100.0),
           "fitted-lines: the shortest plan with this coverage, per cent", "goal_coverage_pct"),
      real("--length", kPlanningGroup, o.goal_length_m, kMetres, above(0.0),
           "fitted-lines: the most coverage within so many metres", "goal_length_m"),
      real("--time", kPlanningGroup, o.goal_time_h, kHours, above(0.0),
           "fitted-lines: the most coverage within so many hours", "goal_time_h"),
      choice("--cover", kPlanningGroup, o.cover, {"hit", "footprint"},
             "fitted-lines, edge-following: lines are laid for and judged by cells that a "
             "sounding hits, or by cells in a beam's footprint (wider swaths, fewer lines)",
             "cover"),
      choice("--counted", kPlanningGroup, o.counted, {"logged", "all"},
             "Plans are laid for and judged by the soundings of logged lines, or by all, turns too",
             "counted"),
      choice("--angles", kPlanningGroup, o.angles, {"line", "ping"},
             "One pair of half-angles a line, in whole degrees, or anew at each waypoint",
             "angles"),
      real("--least-line", kPlanningGroup, o.least_line_m, kMetres, at_least(0.0),
           "No survey line or infill pass is shorter, metres (default: the larger of 20 m and four "
           "turn radii)",
           "least_line_m"),
      real("--least-speed", kPlanningGroup, o.least_speed_mps, kMetresPerSecond, above(0.0),
           "Lines are sailed no slower, m/s (default: half the vehicle's speed)",
           "least_speed_mps"),
      real("--soundings", kPlanningGroup, o.soundings, kNoUnit, within(1.0, 100.0),
           "Soundings wanted a cell (default: 1)", "soundings"),
      real("--line-margin", kPlanningGroup, o.line_margin_pct, kPerCent,
           within(0.0, 100.0 * kMostMargin),
           "fitted-lines, edge-following: per cent of the swath by which neighbours overlap, in "
           "reserve against drift and a wrong map; plans are judged without it",
           "line_margin_pct"),
  };
  for (Option& option : table) {
    if (option.flag == "--coverage") option.excludes = {"--length", "--time"};
    if (option.flag == "--length") option.excludes = {"--time"};
  }
  table = joined({table, spacing_options(o)});
  for (Option& option : table) {
    for (const Usage& usage : kUsedBy) {
      if (option.flag == usage.flag) option.used_by = names_in(usage.planners);
    }
  }
  return table;
}

OptionTable job_options(JobChoice& o) {
  const std::string lines = "Given lines";
  const std::string job = "The whole job";
  Option keep = path("--keep", lines, o.keep,
                     "Plan with the lines of this route: they stay, their order and joins are made "
                     "anew; no planner runs",
                     "keep_file");
  keep.instead_of_choice.emplace();
  Option beside = text("--beside", lines, o.beside,
                       "Lines beside those of this file, on both sides, or around its points and "
                       "polygons; or around X,Y (coordinates of FILE); no planner runs",
                       "beside");
  beside.instead_of_choice = {"--spacing", "--least-line"};
  Option battery = real("--battery", job, o.battery_wh, "watt-hours", above(0.0),
                        "What a sortie may draw, watt-hours (with --power)", "battery_wh");
  return {keep,
          beside,
          whole("--beside-lines", lines, o.beside_lines, within(1.0, 1000.0),
                "Lines to each side, or around a point or polygon (default: 1)", "beside_lines"),
          text("--berth", job, o.berth,
               "Begin and end at X,Y (coordinates of FILE; where these are degrees, "
               "longitude,latitude)",
               "berth"),
          real("--cross-lines", job, o.cross_lines_pct, kPerCent, above_at_most(0.0, 100.0),
               "Cross-lines, sailed first: their length as per cent of the main scheme's",
               "cross_lines_pct"),
          flag("--patch-test", job, o.patch_test,
               "Lines for latency, pitch, roll and yaw, where the seafloor suits them, sailed "
               "before all others",
               "patch_test"),
          real("--sortie-hours", job, o.sortie_h, kHours, above(0.0),
               "Cut the job into sorties from the berth and back of no more hours, contingency "
               "included",
               "sortie_hours"),
          battery,
          text("--daylight", job, o.daylight, "Sorties lie between these times, as 06:00-18:00",
               "daylight"),
          whole("--boats", job, o.boats, within(1.0, 8.0),
                "Share the job among so many boats, about equally long out and never on "
                "neighbouring lines at the same time",
                "boats")};
}

Option north_option(const std::string& group, std::string& north) {
  return choice("--north", group, north, {"true", "grid"},
                "North that --heading counts from: true, or that of the CRS's grid", "north");
}

Option mission_items_option(const std::string& group, ExportChoice& choice) {
  return whole("--mission-items", group, choice.mission_items,
               "waypoints: cut missions into parts of so many items; 0: do not", "mission_items");
}

OptionTable exporting_options(ExportChoice& choice) {
  const std::string group = "Files for autopilots and survey packages";
  return {texts("--export", group, choice.formats,
                "Write the route as these too, separated by commas: " + export_format_names(),
                "export"),
          real("--export-tolerance", group, choice.tolerance_m, kMetres, at_least(0.0),
               "Exported paths leave out waypoints within this of the way, metres",
               "export_tolerance_m"),
          mission_items_option(group, choice)};
}

OptionTable output_options(OutputOptions& o) {
  Option folder = path("-o,--output", "", o.folder, "Folder for the results", "");
  folder.not_empty = true;
  return {folder, flag("--json", "", o.json, "Print the results as JSON", ""),
          flag("--quiet", "", o.quiet, "Print nothing but errors", "")};
}

std::string in_flags(const std::string& sentence) {
  std::string text;
  std::size_t from = 0;
  while (from < sentence.size()) {
    const std::size_t open = sentence.find('<', from);
    const std::size_t close =
        open == std::string::npos ? std::string::npos : sentence.find('>', open);
    if (close == std::string::npos) break;
    const std::string field = sentence.substr(open + 1, close - open - 1);
    text += sentence.substr(from, open - from);
    text += is_field(field) ? flag_of(field) : "<" + field + ">";
    from = close + 1;
  }
  return text + sentence.substr(std::min(from, sentence.size()));
}

std::string in_flags(const std::exception& error) {
  const std::string text = error.what();
  const auto* usage = dynamic_cast<const UsageError*>(&error);
  if (usage == nullptr || usage->field().empty()) return in_flags(text);
  return in_flags("<" + usage->field() + ">" + text.substr(usage->field().size()));
}

}  // namespace swathplan

#include "apps/adapt/adapt_common.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/planning.h"
#include "apps/watch/terminal_watch.h"
#include "io/files/atomic_file.h"
#include "io/seafloor/area_import.h"
#include "mesh/base/error.h"
#include "mesh/plane/area_query.h"
#include "mesh/survey_area.h"
#include "mesh/synthetic.h"
#include "planners/steering/led_round.h"
#include "planners/wording.h"

namespace swathplan {
namespace {

/// Kept from no-go areas, metres.
constexpr double kNoGoRoom = 1.0;

// A route of many kilometres is scored on no more cells than this: the report is drawn from them.
constexpr double kCells = 250000.0;

Survey mission_survey(const AdaptOutput& output, const Site& site) {
  SurveyOptions options;
  ScoringChoice& scoring = options.scoring;
  scoring.resolution_m = std::max(1.0, std::ceil(std::sqrt(area_m2(site.survey_area) / kCells)));
  scoring.ping_spacing_m = scoring.resolution_m;
  scoring.nodata = "open";
  scoring.holiday_m2 = 10.0 * scoring.resolution_m * scoring.resolution_m;
  scoring.hit_only = true;
  scoring.threads = output.threads;
  options.sonar.preset = "norbit-iwbms";
  options.sonar.beam_spacing = "equidistant";
  options.sonar.max_opening_deg = 178.0;
  options.vehicle.preset = "auv";
  options.noise.seed = output.seed;
  return survey_of(options);
}

// Half-angles that sweep `range_m` to each side at `depth_m` below the sonar.
FanAngles side_fan(double range_m, double depth_m) {
  constexpr double kWidest = 88.0;  // beams nearer the horizon meet no seafloor
  const double half = std::min(std::atan2(range_m, depth_m) * 180.0 / std::numbers::pi, kWidest);
  return {Angle::degrees(half), Angle::degrees(half)};
}

std::unique_ptr<Site> flat_site(const SurveyBox& box, double margin_m, double depth_m) {
  const Box2 around = extent(box_area(box));
  auto site = std::make_unique<Site>();
  const Vec2 size = around.size() + Vec2::Constant(2.0 * margin_m);
  site->imported.seafloor = flat(size.x(), size.y(), depth_m);
  for (Vec3& v : site->imported.seafloor.vertices) {
    v.head<2>() += around.min - Vec2::Constant(margin_m);
  }
  site->depths = std::make_unique<DepthQuery>(site->seafloor());
  site->water = outline(site->seafloor());
  site->survey_area = box_area(box);
  return site;
}

/// Cuts the route where it enters and leaves the area, marks what lies inside infeasible, and
/// returns these metres.
double mark_no_go(Route& route, const Area& no_go) {
  constexpr double kEnd = 1e-9;  // a cut so near to a waypoint is that waypoint
  const AreaQuery query(no_go);
  std::vector<Waypoint> cut;
  double inside_m = 0.0;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    Waypoint piece = route.waypoints[i];
    const Vec2 from = piece.position;
    const Vec2 way = route.waypoints[i + 1].position - from;
    const bool feasible = piece.feasible;
    double at = 0.0;
    const auto add = [&](double to, bool blocked) {
      if (to <= at + kEnd) return;
      piece.position = from + at * way;
      piece.feasible = feasible && !blocked;
      cut.push_back(piece);
      at = to;
    };
    for (const auto& [low, high] : query.clip(from, from + way)) {
      add(low, false);
      add(high, true);
      inside_m += (high - low) * way.norm();
    }
    add(1.0, false);
  }
  cut.push_back(route.waypoints.back());
  route.waypoints = std::move(cut);
  return inside_m;
}

/// Round everything, with room to go round it.
Area open_water(const Route& route, const Area& no_go) {
  constexpr double kLeastRoom = 20.0;  // metres
  Box2 box = extent(no_go);
  for (const Waypoint& w : route.waypoints) box.extend(w.position);
  const Vec2 room = Vec2::Constant(kLeastRoom) + 0.1 * box.size();
  const Vec2 low = box.min - room;
  const Vec2 high = box.max + room;
  return {{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}};
}

std::string cut_note(const std::vector<CutLine>& cut) {
  constexpr std::size_t kMostNamed = 12;
  double left_out_m = 0.0;
  std::string names;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    left_out_m += cut[i].left_out_m;
    if (i < kMostNamed && cut[i].line) {
      names += fmt::format("{}{}", i > 0 ? ", " : "", *cut[i].line);
    }
  }
  return fmt::format(
      "{:.0f} m of {} lie in no-go areas or within {:g} m of them and are not sailed (track{} "
      "{}{})",
      left_out_m, counted(cut.size(), "track"), kNoGoRoom, cut.size() == 1 ? "" : "s", names,
      cut.size() > kMostNamed ? ", ..." : "");
}

}  // namespace

OptionTable adapt_output_options(AdaptOutput& output) {
  Option folder = path("-o,--output", "", output.folder, "Output folder", "");
  folder.not_empty = true;
  return {folder, flag("--json", "", output.json, "Print the figures as JSON", ""),
          flag("--quiet", "", output.quiet, "Print nothing", ""),
          whole("--seed", "", output.seed, "Seed of the world", "seed"),
          whole("--threads", "", output.threads, at_least(0.0),
                "Threads; 0: all cores (no result depends on it)", "")};
}

Command adapt_mode(const std::string& mode, const std::string& what, OptionTable options,
                   const AdaptOutput& output, std::function<void()> run) {
  return {mode,
          what,
          std::move(options),
          [&output, run = std::move(run)] {
            check_folder(output.folder);
            run();
          },
          {}};
}

OptionTable box_options(BoxOptions& options) {
  Option corner{.flag = "--corner",
                .group = "",
                .slot = &options.corner,
                .unit = kNoUnit,
                .rule = any_number(),
                .help = "South-west corner of the box, x,y of the file",
                .name = "corner"};
  corner.count = 2;
  return {choice("--start-corner", "", options.start, {"sw", "se", "nw", "ne"},
                 "Where the first track begins (along the tracks is 'n')", "start_corner"),
          real("--azimuth", "", options.azimuth_deg, kDegrees, any_number(),
               "Of the tracks, degrees from true north", "azimuth_deg"),
          corner};
}

SurveyBox box_of(const BoxOptions& options, double width_m, double length_m, const Frame& frame) {
  const auto start = start_corner(options.start);
  if (!start) throw UsageError("start corner", options.start, "must be sw, se, nw or ne");
  SurveyBox box{Vec2::Zero(), Angle::degrees(options.azimuth_deg), width_m, length_m, *start};
  if (options.corner.size() == 2) {
    box.corner = frame.to_local(Vec2(options.corner[0], options.corner[1]));
  }
  return box;
}

Area box_area(const SurveyBox& box) {
  Ring ring{box_point(box, 0, 0), box_point(box, box.width_m, 0),
            box_point(box, box.width_m, box.length_m), box_point(box, 0, box.length_m)};
  if (signed_area(ring) < 0.0) std::reverse(ring.begin(), ring.end());
  return {{std::move(ring), {}}};
}

tbb::global_control thread_limit(const AdaptOutput& output) {
  constexpr std::size_t kAll = 1024;
  return {tbb::global_control::max_allowed_parallelism,
          output.threads > 0 ? static_cast<std::size_t>(output.threads) : kAll};
}

Option missions_option(int& missions, const std::string& what) {
  return whole("--missions", "", missions, within(1.0, 1000000.0), what, "missions");
}

Provenance adapt_provenance(const std::string& command, const OptionTable& typed,
                            const OptionTable& in_force) {
  Provenance provenance;
  provenance.version = SWATHPLAN_VERSION;
  provenance.command = command;
  record(provenance, typed, in_force);
  return provenance;
}

MissionOutput mission_output(const SurveyBox& box, std::span<const SurveyTrack> tracks,
                             double range_m, double depth_m, Provenance provenance) {
  constexpr double kSpeed = 1.5;  // metres per second
  MissionOutput out;
  out.route = mission_route(box, tracks, {side_fan(range_m, depth_m), kSpeed});
  out.provenance = std::move(provenance);
  return out;
}

Option no_go_option(std::filesystem::path& file) {
  return path("--no-go", "", file, "Go round these polygons, metres as of --corner", "no_go_file");
}

Area abstract_no_go(const SiteOptions& choice, const SurveyBox& box, double reach_m,
                    MissionOutput& mission) {
  if (choice.no_go.empty()) return {};
  Box2 data = extent(box_area(box));
  data.min.array() -= reach_m;
  data.max.array() += reach_m;
  ImportedArea read = import_area(choice.no_go, {},
                                  {.data_extent = data,
                                   .buffer_m = choice.buffer_m,
                                   .layers = choice.layers,
                                   .tolerance_m = 0.1 * kNoGoRoom,
                                   .rounding = Rounding::around});
  for (const std::string& note : read.notes) mission.notes.push_back(in_flags(note));
  return std::move(read.area);
}

void keep_out_of(const Area& no_go, const Area& water, MissionOutput& mission) {
  Route& route = mission.route;
  if (no_go.empty() || route.waypoints.empty()) return;
  LedRound led =
      led_round(route, no_go, water.empty() ? open_water(route, no_go) : water, kNoGoRoom);
  if (led.route.waypoints.empty()) {
    throw InvalidInput("all tracks of the mission lie in no-go areas; set --corner");
  }
  if (positions(led.route.waypoints) == positions(route.waypoints)) return;
  const double before_m = length_m(route);
  route = std::move(led.route);
  const double blocked_m = mark_no_go(route, no_go);
  if (!led.cut.empty()) mission.notes.push_back(cut_note(led.cut));
  mission.notes.push_back(fmt::format(
      "the route goes round no-go areas: {:.0f} m instead of {:.0f} m; the planner's own figures "
      "are those of whole tracks",
      length_m(route), before_m));
  if (blocked_m > 0.0) {
    mission.notes.push_back(fmt::format(
        "{:.0f} m of the route lead through no-go areas and are marked infeasible: no way round "
        "them was found",
        blocked_m));
  }
}

void write_mission(const AdaptOutput& output, const MissionOutput& mission, const Site& site) {
  const Survey survey = mission_survey(output, site);
  nlohmann::ordered_json json;
  json["planner"] = mission.planner;
  for (const auto& [name, value] : mission.figures) json[name] = value;
  json["notes"] = mission.notes;
  json["seed"] = mission.provenance.seed;
  json["version"] = mission.provenance.version;
  TerminalWatch watch(output.quiet, output.folder);
  const Scorer scorer(site, survey, Watch(watch));
  Plan plan;
  plan.route = mission.route;
  plan.notes = mission.notes;
  ScoredRoute scored = scorer.score("scoring", plan.route);
  std::vector<PlannedSurvey> surveys;
  surveys.push_back(
      recorded(mission.planner, mission.label, std::move(plan), std::move(scored), site, survey));
  watch.phase("writing results");
  const auto writing = watch.writing();
  write_all_or_none(output.folder, [&](const std::filesystem::path& staging) {
    write_text_atomically(staging / "mission.json", json.dump(2) + "\n");
    write_tracks_png(staging / "tracks.png", mission.pictures);
    write_survey(staging, surveys[0], site, mission.provenance);
    write_survey_toml(staging, mission.provenance);
    write_survey_report(staging / "report.html", mission.label, surveys, site, mission.provenance);
    remove_old_survey(output.folder, site);
  });
  watch.rest();
  if (output.json) {
    fmt::print("{}\n", json.dump(2));
  } else if (!output.quiet) {
    for (const auto& [name, value] : mission.figures) fmt::print("{:<32} {:g}\n", name, value);
    for (const std::string& note : mission.notes) fmt::print(stderr, "note: {}\n", note);
    fmt::print("report: {}\n", (output.folder / "report.html").string());
  }
}

void write_flat_mission(const AdaptOutput& output, const MissionOutput& mission,
                        const SurveyBox& box, double range_m) {
  // Tracks may lie outside the box by up to a range, and look as far again.
  write_mission(output, mission, *flat_site(box, 2.0 * range_m, flat_depth_m(range_m)));
}

void write_live_mission(const AdaptOutput& output, const MissionOutput& mission,
                        const SurveyBox& box, double range_m) {
  AdaptOutput silent = output;
  silent.quiet = true;
  silent.json = false;
  write_flat_mission(silent, mission, box, range_m);
}

std::vector<std::vector<double>> run_watched(const Study& study, const AdaptOutput& output) {
  TerminalWatch watch(output.quiet, output.folder);
  watch.search();
  watch.phase("study " + study.name);
  return run_study(study, output.folder, Watch(watch));
}

}  // namespace swathplan

#include "apps/adapt/adapt_accordion.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

#include "apps/adapt/adapt_live.h"
#include "apps/adapt/adapt_planners.h"
#include "mesh/base/error.h"
#include "mesh/base/random.h"
#include "planners/adaptive/simulated_strips.h"

namespace swathplan {
namespace {

// The costs of images are measured against their surroundings.
constexpr double kImageThreshold = 1.0;
// An image places an object by slant range on a flat bottom; slopes and heights move it.
constexpr double kImageClearance = 3.0;

// What is drawn in a picture besides tracks.
constexpr const char* kDots = "red: objects";

std::vector<std::pair<std::string, double>> figures_of(const AccordionState& state) {
  const AccordionOptions& o = state.options;
  const double lawnmower =
      mission_length_m(overlapping_lawnmower(o.width_m, o.spacing_m), o.length_m);
  return {{"tracks", static_cast<double>(state.sailed.size())},
          {"length_m", state.sailed_m},
          {"lawnmower_length_m", lawnmower},
          {"improvement_pct", gain(state).whole_pct}};
}

void add_object_figures(MissionOutput& out, int objects, int seen_twice) {
  out.figures.emplace_back("objects", objects);
  out.figures.emplace_back("objects_seen_from_both_sides", seen_twice);
}

OptionTable planner_options(AccordionCommand& c) {
  return joined(
      {{real("--width", "", c.planner.width_m, kMetres, any_number(),
             "Of the area across the tracks, m", "width_m"),
        real("--length", "", c.planner.length_m, kMetres, any_number(), "Of a track, m",
             "length_m"),
        real("--spacing", "", c.planner.spacing_m, kMetres, any_number(), "Strip width W, m",
             "spacing_m"),
        real("--nadir-gap", "", c.planner.nadir_gap_m, kMetres, any_number(),
             "Half-width of the blind strip, m", "nadir_gap_m"),
        real("--threshold", "", c.threshold, kNoUnit, any_number(),
             "Cost from which something is an object (default: 0.5; images 1)", "threshold"),
        real("--clearance", "", c.clearance_m, kMetres, any_number(),
             "Uncertainty of an object's place, m (bounded rule; default: 0; images 3)",
             "clearance_m"),
        choice("--rule", "", c.rule, {"basic", "bounded"}, "When it folds", "rule")},
       box_options(c.box),
       adapt_output_options(c.output)});
}

// A study makes its own areas, so it takes no width, length or place.
OptionTable study_options(AccordionCommand& c) {
  return joined({only(planner_options(c), {"--spacing", "--nadir-gap", "--clearance", "--rule"}),
                 adapt_output_options(c.output)});
}

OptionTable world_options(AccordionCommand& c) {
  return {real("--p-obj", "", c.p_obj, kNoUnit, any_number(),
               "Share of strips with an object, without FILE", "p_obj")};
}

OptionTable sonar_options(AccordionCommand& c) {
  return {
      whole("--objects", "", c.objects, within(0.0, 10000.0), "Objects dropped on FILE", "objects"),
      real("--altitude", "", c.sonar.altitude_m, kMetres, any_number(),
           "Of the sonar above FILE, m", "altitude_m"),
      real("--pixel", "", c.sonar.pixel_m, kMetres, any_number(), "Image pixel across, m",
           "pixel_m"),
      real("--ping-spacing", "", c.sonar.ping_spacing_m, kMetres, any_number(),
           "Along the track, m", "ping_spacing_m"),
      real("--looks", "", c.sonar.looks, kNoUnit, any_number(), "Of the speckle; 0: none", "looks"),
      flag("--no-gap-filler", "", c.no_gap_filler, "No multibeam sonar over the nadir gap",
           "no_gap_filler")};
}

OptionTable image_options(AccordionCommand& c) {
  return {
      real("--pixel", "", c.pixel_m, kMetres, any_number(), "Pixel of images across, m", "pixel_m"),
      real("--row", "", c.row_m, kMetres, any_number(), "Row of images along, m", "row_m")};
}

/// `rows` are those of the mode, besides the planner's.
Provenance provenance(const AccordionCommand& c, const AccordionOptions& o, const std::string& mode,
                      OptionTable (*rows)(AccordionCommand&)) {
  AccordionCommand typed = c;
  AccordionCommand now = c;
  now.threshold = o.threshold;
  now.clearance_m = o.clearance_m;
  return adapt_provenance("adapt accordion " + mode, joined({planner_options(typed), rows(typed)}),
                          joined({planner_options(now), rows(now)}));
}

// The box is the survey area.
void refuse_area(const SiteOptions& site) {
  if (!site.area.empty()) {
    throw UsageError("area", "",
                     "the box is the survey area: set --corner, --width and --length instead");
  }
}

void simulate_strips(const AccordionCommand& c) {
  const AccordionOptions o = accordion_of(c, kWorldThreshold);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  const StripWorld world = random_strips(o.width_m, o.spacing_m, c.p_obj, c.output.seed);
  const AccordionMission mission = sail(world, o);
  MissionOutput out =
      mission_output(box, mission.state.sailed, sonar_range_m(o), flat_depth_m(sonar_range_m(o)),
                     provenance(c, o, "simulate", world_options));
  out.planner = "accordion";
  out.label = fmt::format("Accordion ({})", c.rule);
  out.figures = figures_of(mission.state);
  add_object_figures(out, mission.objects, mission.objects_seen_twice);
  TrackPicture picture{out.label, o.width_m, o.length_m, mission.state.sailed, {}, kDots, {}};
  SeededNumbers numbers(mixed_seed(c.output.seed, 99));
  for (const double x : world.objects_m) {
    picture.objects.emplace_back(x, (0.1 + 0.8 * numbers.uniform()) * o.length_m);
  }
  TrackPicture lawnmower = picture;
  lawnmower.title = "Overlapping lawnmower";
  lawnmower.tracks = overlapping_lawnmower(o.width_m, o.spacing_m);
  out.pictures = {picture, lawnmower};
  keep_out_of(abstract_no_go(c.site, box, sonar_range_m(o), out), {}, out);
  write_flat_mission(c.output, out, box, sonar_range_m(o));
}

double mean_depth(const SurveyBox& box, const DepthQuery& depths) {
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const auto d = depths.depth(box_point(box, box.width_m * i / 20, box.length_m * j / 20));
      if (!d) continue;
      sum += *d;
      ++count;
    }
  }
  if (count == 0) throw InvalidInput("the box lies outside the seafloor; set --corner");
  return sum / count;
}

/// The box as the frame of the data counts: its corner from the file's coordinates, its azimuth
/// from true north.
BoxOptions in_frame(BoxOptions box, const ImportedSeafloor& data) {
  box.azimuth_deg -= data.convergence_deg;
  if (box.corner.empty()) return box;
  const Vec2 corner =
      data.seafloor.frame.to_file(local_of(data, Vec2(box.corner[0], box.corner[1])));
  box.corner = {corner.x(), corner.y()};
  return box;
}

void simulate_seafloor(const AccordionCommand& c) {
  const AccordionOptions o = accordion_of(c, kImageThreshold, kImageClearance);
  check(c.sonar);
  auto site = load_site(c.site, Vehicle{});
  const SurveyBox box =
      box_of(in_frame(c.box, site->imported), o.width_m, o.length_m, site->seafloor().frame);
  const double depth = mean_depth(box, *site->depths);
  const auto objects =
      dropped_objects(box, c.objects, o.nadir_gap_m + 3.0, *site->depths, c.output.seed);
  const RayScene scene(with_objects(site->seafloor(), objects), Nodata::open);
  ScanWorld world{&scene, {}, c.sonar, c.cost, !c.no_gap_filler, box};
  world.sonar.seed = c.output.seed;
  world.depth_below = [&](const Vec2& p) {
    return site->depths->depth(p).value_or(site->depths->nearest_depth(p));
  };
  std::filesystem::create_directories(c.output.folder);
  const AccordionState state = sail(o, world, [&](const ScannedTrack& t) {
    write_waterfall_png(c.output.folder / fmt::format("waterfall-{:03}.png", t.track.number),
                        t.image);
  });
  int twice = 0;
  for (const ObjectSights& s : sights(objects, state.sailed, o, world)) {
    twice += s.from_below && s.from_above ? 1 : 0;
  }
  MissionOutput out = mission_output(box, state.sailed, sonar_range_m(o), depth,
                                     provenance(c, o, "simulate", sonar_options));
  out.planner = "accordion";
  out.label = fmt::format("Accordion ({})", c.rule);
  out.provenance.input_file = c.site.file.string();
  out.provenance.input_hash = site->imported.input_hash;
  SiteOptions typed_site = c.site;
  record(out.provenance, site_options(typed_site));
  out.figures = figures_of(state);
  add_object_figures(out, static_cast<int>(objects.size()), twice);
  out.notes = {
      fmt::format("the score takes a sonar at the surface with the same swath; the images "
                  "were made {:g} m above the seafloor",
                  c.sonar.altitude_m)};
  keep_out_of(site->no_go, site->water, out);
  TrackPicture picture{out.label, o.width_m, o.length_m, state.sailed, {}, kDots, {}};
  const Vec2 origin = box_point(box, 0, 0);
  for (const DroppedObject& object : objects) {
    const Vec2 p = object.base.head<2>() - origin;
    picture.objects.emplace_back(p.dot(box_point(box, 1, 0) - origin),
                                 p.dot(box_point(box, 0, 1) - origin));
  }
  out.pictures = {picture};
  site->survey_area = intersect(site->survey_area, box_area(box));
  if (site->survey_area.empty()) throw InvalidInput("the box holds no water; set --corner");
  write_mission(c.output, out, *site);
}

void simulate(const AccordionCommand& c) {
  refuse_area(c.site);
  const auto limit = thread_limit(c.output);
  c.site.file.empty() ? simulate_strips(c) : simulate_seafloor(c);
}

CostMap map_of(const nlohmann::json& side) {
  CostMap map;
  map.first_m = side.value("first_m", 0.0);
  map.step_m = side.at("step_m").get<double>();
  const auto& rows = side.at("rows");
  if (!rows.is_array()) throw InvalidInput("'rows' must be an array of arrays of costs");
  for (const auto& row : rows) {
    const auto values = row.get<std::vector<float>>();
    if (map.rows > 0 && static_cast<int>(values.size()) != map.columns) {
      throw InvalidInput(fmt::format("row {} has {} costs, the first has {}", map.rows,
                                     values.size(), map.columns));
    }
    map.columns = static_cast<int>(values.size());
    map.values.insert(map.values.end(), values.begin(), values.end());
    ++map.rows;
  }
  map.along_m = map.rows * side.value("row_m", 0.0);
  return map;
}

// Rows from the first ping on, heights from port to starboard; null where nothing was met.
NadirHeights heights_of(const nlohmann::json& nadir, const SideScanImage& image) {
  NadirHeights heights{0, 0, image.pixel_m, image.row_m, {}};
  for (const auto& row : nadir.at("rows")) {
    if (heights.rows > 0 && static_cast<int>(row.size()) != heights.columns) {
      throw InvalidInput(fmt::format("nadir row {} has {} heights, the first has {}", heights.rows,
                                     row.size(), heights.columns));
    }
    heights.columns = static_cast<int>(row.size());
    for (const auto& z : row) {
      heights.z.push_back(z.is_null() ? std::numeric_limits<float>::quiet_NaN() : z.get<float>());
    }
    ++heights.rows;
  }
  return heights;
}

AccordionObservation observed_image(const AccordionCommand& c, const nlohmann::json& message,
                                    const AccordionOptions& o, bool port_back) {
  CostMapOptions cost = c.cost;
  cost.threshold = o.threshold;
  const SideScanImage image =
      read_waterfall_png(message["image"].get<std::string>(), c.pixel_m, c.row_m, o.nadir_gap_m);
  AccordionObservation observation = cost_maps(image, port_back, cost);
  if (!message.contains("nadir") || o.nadir_gap_m == 0.0) return observation;
  if (message["nadir"] == "clear") {
    observation.back.blind_m = observation.ahead.blind_m = 0.0;
  } else {
    fill_nadir(observation, heights_of(message["nadir"], image), port_back, cost);
  }
  return observation;
}

void live(const AccordionCommand& c) {
  const AccordionOptions o = accordion_of(c, kWorldThreshold);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  AccordionState state = start_accordion(o);
  bool images = false;
  LivePlanner planner{"accordion", [&] { return next_track(state); }, {}, {}};
  planner.observe = [&](const SurveyTrack& track, const nlohmann::json& message) {
    const bool port_back = port_looks_back(box, track);
    if (!message.contains("image")) {
      state = observe(state, track,
                      {map_of(message.at(port_back ? "port" : "starboard")),
                       map_of(message.at(port_back ? "starboard" : "port"))});
      return;
    }
    // Images have their own threshold, and from the first one on places are uncertain.
    const AccordionOptions image_o = accordion_of(c, kImageThreshold, kImageClearance);
    AccordionState seen = state;
    seen.options.threshold = image_o.threshold;
    seen = observe(std::move(seen), track, observed_image(c, message, image_o, port_back));
    seen.options.threshold = o.threshold;
    seen.options.clearance_m = image_o.clearance_m;
    state = std::move(seen);
    images = true;
  };
  planner.figures = [&] {
    return nlohmann::ordered_json{{"improvement_pct", gain(state).whole_pct}};
  };
  const auto sailed = run_live(std::cin, std::cout, box, {}, planner);
  if (sailed.empty()) return;
  AccordionOptions in_force = state.options;
  if (images) in_force.threshold = c.threshold.value_or(kImageThreshold);
  MissionOutput out = mission_output(box, sailed, sonar_range_m(o), flat_depth_m(sonar_range_m(o)),
                                     provenance(c, in_force, "live", image_options));
  out.planner = "accordion";
  out.label = "Accordion (live)";
  out.figures = figures_of(state);
  out.pictures = {{out.label, o.width_m, o.length_m, sailed, {}, "", {}}};
  write_live_mission(c.output, out, box, sonar_range_m(o));
}

}  // namespace

AccordionRule accordion_rule(const std::string& name) {
  if (name == "basic") return AccordionRule::basic;
  if (name == "bounded") return AccordionRule::bounded;
  throw UsageError("rule", name, "must be basic or bounded");
}

AccordionOptions accordion_of(const AccordionCommand& c, double default_threshold,
                              double default_clearance) {
  AccordionOptions options = c.planner;
  options.rule = accordion_rule(c.rule);
  options.threshold = c.threshold.value_or(default_threshold);
  options.clearance_m = c.clearance_m.value_or(default_clearance);
  check(options);
  return options;
}

Command adapt_accordion_command() {
  auto c = std::make_shared<AccordionCommand>();
  return {
      "accordion",
      "Lawnmower that folds where the sonar meets objects of interest",
      {},
      {},
      {adapt_mode("simulate",
                  "One mission: over FILE with ray-cast images, without it over abstract "
                  "strips",
                  joined({site_options(c->site, false), planner_options(*c), sonar_options(*c),
                          world_options(*c)}),
                  c->output, [c] { simulate(*c); }),
       adapt_mode(
           "study", "Monte Carlo over alpha and p_obj, as published",
           joined({study_options(*c), {missions_option(c->missions, "Per alpha and p_obj")}}),
           c->output, [c] { study_accordion(*c); }),
       adapt_mode("live", "JSON lines: observations in, tracks out",
                  joined({planner_options(*c), image_options(*c)}), c->output, [c] { live(*c); })}};
}

}  // namespace swathplan

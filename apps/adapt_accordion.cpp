#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "apps/adapt_common.h"
#include "apps/adapt_live.h"
#include "apps/adapt_planners.h"
#include "io/adaptive_study.h"
#include "io/atomic_file.h"
#include "mesh/error.h"
#include "planners/accordion_scan.h"
#include "planners/adaptive_worlds.h"

namespace swathplan {
namespace {

struct AccordionCommand {
  SiteOptions site;
  BoxOptions box;
  AdaptOutput output;
  AccordionOptions planner{.width_m = 1000.0, .length_m = 500.0};
  std::string rule = "basic";
  std::optional<double> threshold, clearance_m;
  double p_obj = 0.2;
  int objects = 12;
  SideScanSonar sonar;
  CostMapOptions cost;
  bool no_gap_filler = false;
  int missions = 100;
  double pixel_m = 0.1, row_m = 0.2;
};

// Abstract costs are 0.1 and 1; the costs of images are measured against their surroundings.
constexpr double kWorldThreshold = 0.5;
constexpr double kImageThreshold = 1.0;
// An image places an object by slant range on a flat bottom; slopes and heights move it.
constexpr double kImageClearance = 3.0;

AccordionRule rule_of(const std::string& name) {
  if (name == "basic") return AccordionRule::basic;
  if (name == "bounded") return AccordionRule::bounded;
  throw UsageError(fmt::format("--rule {}; must be basic or bounded", name));
}

AccordionOptions planner_of(const AccordionCommand& c, double default_threshold,
                            double default_clearance = 0.0) {
  AccordionOptions options = c.planner;
  options.rule = rule_of(c.rule);
  options.threshold = c.threshold.value_or(default_threshold);
  options.clearance_m = c.clearance_m.value_or(default_clearance);
  check(options);
  return options;
}

std::vector<std::pair<std::string, double>> figures_of(const AccordionState& state, int objects,
                                                       int seen_twice) {
  const AccordionOptions& o = state.options;
  const double lawnmower =
      mission_length_m(overlapping_lawnmower(o.width_m, o.spacing_m), o.length_m);
  return {{"tracks", static_cast<double>(state.sailed.size())},
          {"length_m", state.sailed_m},
          {"lawnmower_length_m", lawnmower},
          {"improvement_pct", gain(state).whole_pct},
          {"objects", objects},
          {"objects_seen_from_both_sides", seen_twice}};
}

Provenance provenance(const AccordionCommand& c, const AccordionOptions& o,
                      const std::string& mode) {
  return adapt_provenance("adapt accordion " + mode, c.output.seed,
                          {{"width_m", o.width_m},
                           {"length_m", o.length_m},
                           {"spacing_m", o.spacing_m},
                           {"nadir_gap_m", o.nadir_gap_m},
                           {"threshold", o.threshold},
                           {"clearance_m", o.clearance_m},
                           {"rule", c.rule},
                           {"start_corner", c.box.start}});
}

void simulate_strips(const AccordionCommand& c) {
  const AccordionOptions o = planner_of(c, kWorldThreshold);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  const StripWorld world = random_strips(o.width_m, o.spacing_m, c.p_obj, c.output.seed);
  const AccordionMission mission = sail(world, o);
  const double depth = 0.25 * sonar_range_m(o);
  MissionOutput out{"accordion", fmt::format("Accordion ({})", c.rule), {}, {}, {},
                    {},          provenance(c, o, "simulate")};
  out.provenance.options.emplace_back("p_obj", c.p_obj);
  out.route = mission_route(box, mission.state.sailed, {side_fan(sonar_range_m(o), depth), 1.5});
  out.figures = figures_of(mission.state, mission.objects, mission.objects_seen_twice);
  TrackPicture picture{out.label, o.width_m, o.length_m, mission.state.sailed, {}, "", {}};
  SeededNumbers numbers(mixed_seed(c.output.seed, 99));
  for (const double x : world.objects_m) {
    picture.objects.emplace_back(x, (0.1 + 0.8 * numbers.uniform()) * o.length_m);
  }
  TrackPicture lawnmower = picture;
  lawnmower.title = "Overlapping lawnmower";
  lawnmower.tracks = overlapping_lawnmower(o.width_m, o.spacing_m);
  out.pictures = {picture, lawnmower};
  write_mission(c.output, out, *flat_site(box, sonar_range_m(o), depth));
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

void simulate_seafloor(const AccordionCommand& c) {
  const AccordionOptions o = planner_of(c, kImageThreshold, kImageClearance);
  check(c.sonar);
  auto site = load_site(c.site, Vehicle{});
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, site->seafloor().frame);
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
  MissionOutput out{"accordion", fmt::format("Accordion ({})", c.rule), {}, {}, {},
                    {},          provenance(c, o, "simulate")};
  out.provenance.input_file = c.site.file.string();
  out.provenance.input_hash = site->imported.input_hash;
  out.provenance.options.emplace_back("objects", static_cast<std::int64_t>(c.objects));
  out.route = mission_route(box, state.sailed, {side_fan(sonar_range_m(o), depth), 1.5});
  out.figures = figures_of(state, static_cast<int>(objects.size()), twice);
  out.notes = {
      fmt::format("the score takes a sonar at the surface with the same swath; the images "
                  "were made {:g} m above the seafloor",
                  c.sonar.altitude_m)};
  TrackPicture picture{out.label, o.width_m, o.length_m, state.sailed, {}, "", {}};
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
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  c.output.threads > 0 ? static_cast<std::size_t>(c.output.threads)
                                                       : static_cast<std::size_t>(1) << 10U);
  c.site.file.empty() ? simulate_strips(c) : simulate_seafloor(c);
}

constexpr std::array<double, 7> kAlphas{0.01, 0.1, 0.25, 0.5, 0.75, 1.0, 2.0};
constexpr std::array<double, 7> kAreasKm2{5.5, 3.8, 3.3, 2.73, 2.34, 2.05, 1.36};
constexpr int kShares = 21;

// One cell: a hundred missions with one alpha and one share of strips with objects.
std::vector<double> study_cell(const AccordionCommand& c, AccordionRule rule, std::size_t cell) {
  const std::size_t a = cell / kShares;
  const double share = static_cast<double>(cell % kShares) / (kShares - 1);
  AccordionOptions o = c.planner;
  o.rule = rule;
  o.threshold = kWorldThreshold;
  o.length_m = o.spacing_m / kAlphas[a];
  o.width_m =
      o.spacing_m * std::max(1.0, std::round(kAreasKm2[a] * 1e6 / o.length_m / o.spacing_m));
  const double lawnmower =
      mission_length_m(overlapping_lawnmower(o.width_m, o.spacing_m), o.length_m);
  double sum = 0.0, periods = 0.0, worst = -1e300, excess = -1e300;
  int better = 0, unseen = 0;
  for (int i = 0; i < c.missions; ++i) {
    const auto world =
        random_strips(o.width_m, o.spacing_m, share,
                      mixed_seed(c.output.seed, cell, static_cast<std::uint64_t>(i)));
    const auto mission = sail(world, o);
    const auto g = gain(mission.state);
    sum += g.whole_pct;
    periods += g.periods_pct;
    worst = std::max(worst, -g.whole_pct);
    excess = std::max(excess, (mission.state.sailed_m - lawnmower) / (o.length_m + o.spacing_m));
    better += g.whole_pct > 1e-9 ? 1 : 0;
    unseen += mission.objects - mission.objects_seen_twice;
  }
  return {kAlphas[a],
          100.0 * share,
          o.width_m,
          o.length_m,
          sum / c.missions,
          periods / c.missions,
          published_improvement_pct(kAlphas[a], 100.0 * share),
          -worst,
          excess,
          100.0 * better / c.missions,
          static_cast<double>(unseen)};
}

std::string study_summary(const std::vector<std::vector<double>>& rows) {
  double squares = 0.0;
  double unseen = 0.0;
  for (const auto& r : rows) {
    squares += (r[4] - r[6]) * (r[4] - r[6]);
    unseen += r[10];
  }
  std::string text = fmt::format(
      "RMS difference from the published function: {:.2f} points; objects "
      "not seen from both sides: {:g}\n",
      std::sqrt(squares / static_cast<double>(rows.size())), unseen);
  text +=
      "alpha   mean %  break-even p_obj %  shorter % (p_obj to 100, 90, 80)  worst, tracks over\n";
  for (std::size_t a = 0; a < kAlphas.size(); ++a) {
    double mean = 0.0, worst = -1e300, even = 100.0;
    std::array<double, kShares> shorter{};
    for (int k = 0; k < kShares; ++k) {
      const auto& r = rows[a * kShares + static_cast<std::size_t>(k)];
      mean += r[4] / kShares;
      worst = std::max(worst, r[8]);
      shorter[static_cast<std::size_t>(k)] = r[9];
      if (k == 0 || even < 100.0 || r[4] >= 0.0) continue;
      const auto& before = rows[a * kShares + static_cast<std::size_t>(k) - 1];
      even = before[1] + (r[1] - before[1]) * before[4] / (before[4] - r[4]);
    }
    const auto upto = [&](int last) {
      double sum = 0.0;
      for (int k = 0; k <= last; ++k) sum += shorter[static_cast<std::size_t>(k)];
      return sum / (last + 1);
    };
    text +=
        fmt::format("{:<7g} {:6.2f}  {:18.1f}  {:6.1f} {:6.1f} {:6.1f}                {:10.2f}\n",
                    kAlphas[a], mean, even, upto(20), upto(18), upto(16), worst);
  }
  return text;
}

void study(const AccordionCommand& c) {
  const AccordionRule rule = rule_of(c.rule);
  if (c.missions < 1)
    throw UsageError(fmt::format("--missions {}; must be at least 1", c.missions));
  check(planner_of(c, kWorldThreshold));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  c.output.threads > 0 ? static_cast<std::size_t>(c.output.threads)
                                                       : static_cast<std::size_t>(1) << 10U);
  Study s{fmt::format("accordion-{}", c.rule),
          fmt::format("seed {} missions {} spacing_m {}", c.output.seed, c.missions,
                      c.planner.spacing_m),
          {"alpha", "p_obj_pct", "width_m", "length_m", "mean_improvement_pct",
           "mean_improvement_periods_pct", "published_improvement_pct", "worst_improvement_pct",
           "worst_excess_tracks", "shorter_pct", "objects_not_seen_twice"},
          kAlphas.size() * kShares,
          [&](std::size_t cell) { return study_cell(c, rule, cell); }};
  const auto rows = run_study(s, c.output.folder, study_progress("accordion", c.output.quiet));
  Chart chart{
      fmt::format("Accordion ({}): improvement on the lawnmower, % (dashed: published)", c.rule),
      "strips with objects, %",
      "",
      {}};
  for (std::size_t a = 0; a < kAlphas.size(); ++a) {
    ChartCurve ours{fmt::format("alpha {:g}", kAlphas[a]), {}, {}, false};
    ChartCurve published{"", {}, {}, true};
    for (int k = 0; k < kShares; ++k) {
      const auto& r = rows[a * kShares + static_cast<std::size_t>(k)];
      ours.x.push_back(r[1]);
      ours.y.push_back(r[4]);
      published.x.push_back(r[1]);
      published.y.push_back(r[6]);
    }
    chart.curves.push_back(std::move(ours));
    chart.curves.push_back(std::move(published));
  }
  write_chart_png(c.output.folder / (s.name + ".png"), chart);
  const std::string summary = study_summary(rows);
  write_text_atomically(c.output.folder / (s.name + ".txt"), summary);
  if (!c.output.quiet) fmt::print("{}", summary);
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
  return map;
}

void live(const AccordionCommand& c) {
  const AccordionOptions o = planner_of(c, kWorldThreshold);
  const SurveyBox box = box_of(c.box, o.width_m, o.length_m, {});
  AccordionState state = start_accordion(o);
  LivePlanner planner{"accordion", [&] { return next_track(state); }, {}, {}};
  planner.observe = [&](const SurveyTrack& track, const nlohmann::json& message) {
    const bool port_back = port_looks_back(box, track);
    AccordionObservation observation;
    if (message.contains("image")) {
      CostMapOptions cost = c.cost;
      cost.threshold = o.threshold;
      observation = cost_maps(read_waterfall_png(message["image"].get<std::string>(), c.pixel_m,
                                                 c.row_m, o.nadir_gap_m),
                              port_back, cost);
    } else {
      observation = {map_of(message.at(port_back ? "port" : "starboard")),
                     map_of(message.at(port_back ? "starboard" : "port"))};
    }
    state = observe(state, track, observation);
  };
  planner.figures = [&] {
    return nlohmann::ordered_json{{"improvement_pct", gain(state).whole_pct}};
  };
  const auto sailed = run_live(std::cin, std::cout, box, {}, planner);
  if (sailed.empty()) return;
  const double depth = 0.25 * sonar_range_m(o);
  MissionOutput out{"accordion", "Accordion (live)", {}, {}, {}, {}, provenance(c, o, "live")};
  out.route = mission_route(box, sailed, {side_fan(sonar_range_m(o), depth), 1.5});
  out.figures = figures_of(state, 0, 0);
  out.pictures = {{out.label, o.width_m, o.length_m, sailed, {}, "", {}}};
  AdaptOutput quiet = c.output;
  quiet.quiet = true;
  quiet.json = false;
  write_mission(quiet, out, *flat_site(box, sonar_range_m(o), depth));
}

void add_planner_options(CLI::App& command, AccordionCommand& c) {
  command.add_option("--width", c.planner.width_m, "Of the area across the tracks, m")
      ->capture_default_str();
  command.add_option("--length", c.planner.length_m, "Of a track, m")->capture_default_str();
  command.add_option("--spacing", c.planner.spacing_m, "Strip width W, m")->capture_default_str();
  command.add_option("--nadir-gap", c.planner.nadir_gap_m, "Half-width of the blind strip, m");
  command.add_option("--threshold", c.threshold,
                     "Cost from which something is an object (default: 0.5; images 1)");
  command.add_option("--clearance", c.clearance_m,
                     "Uncertainty of an object's place, m (bounded rule; default: 0; images 3)");
  command.add_option("--rule", c.rule, "basic or bounded")->capture_default_str();
  add_box_options(command, c.box);
  add_adapt_output(command, c.output);
}

void add_sonar_options(CLI::App& command, AccordionCommand& c) {
  command.add_option("--objects", c.objects, "Objects dropped on FILE")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  command.add_option("--altitude", c.sonar.altitude_m, "Of the sonar above FILE, m")
      ->capture_default_str();
  command.add_option("--pixel", c.sonar.pixel_m, "Image pixel across, m")->capture_default_str();
  command.add_option("--ping-spacing", c.sonar.ping_spacing_m, "Along the track, m")
      ->capture_default_str();
  command.add_option("--looks", c.sonar.looks, "Of the speckle; 0: none")->capture_default_str();
  command.add_flag("--no-gap-filler", c.no_gap_filler, "No multibeam sonar over the nadir gap");
}

}  // namespace

void add_adapt_accordion(CLI::App& adapt) {
  auto* accordion = adapt.add_subcommand(
      "accordion", "Lawnmower that folds where the sonar meets objects of interest");
  accordion->require_subcommand(1);
  auto c = std::make_shared<AccordionCommand>();
  auto* sub = accordion->add_subcommand(
      "simulate", "One mission: over FILE with ray-cast images, without it over abstract strips");
  add_site_options(*sub, c->site);
  sub->get_option("FILE")->required(false);
  add_planner_options(*sub, *c);
  add_sonar_options(*sub, *c);
  sub->add_option("--p-obj", c->p_obj, "Share of strips with an object, without FILE")
      ->capture_default_str();
  sub->callback([c] { simulate(*c); });
  sub = accordion->add_subcommand("study", "Monte Carlo over alpha and p_obj, as published");
  add_planner_options(*sub, *c);
  sub->add_option("--missions", c->missions, "Per alpha and p_obj")->capture_default_str();
  sub->callback([c] { study(*c); });
  sub = accordion->add_subcommand("live", "JSON lines: observations in, tracks out");
  add_planner_options(*sub, *c);
  sub->add_option("--pixel", c->pixel_m, "Pixel of images across, m")->capture_default_str();
  sub->add_option("--row", c->row_m, "Row of images along, m")->capture_default_str();
  sub->callback([c] { live(*c); });
}

}  // namespace swathplan

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outputs.h"
#include "io/files/atomic_file.h"
#include "io/pictures/lines_png.h"
#include "io/results/provenance_json.h"
#include "io/route/route_csv.h"
#include "io/route/route_geojson.h"
#include "mesh/base/error.h"
#include "planners/fitted/line_design.h"

namespace swathplan {
namespace {

struct LinesCommand {
  SiteOptions site;
  SurveyOptions survey;
  OutputOptions output;
  ExportChoice exports;
  std::vector<std::string> methods{"auto"};
  double opening_deg = 120.0, overlap_pct = 0.0, missed_pct = 0.05;
};

const std::vector<std::pair<std::string, LineMethod>> kMethods{
    {"auto", LineMethod::automatic},
    {"field", LineMethod::field},
    {"straight", LineMethod::straight},
    {"edge-following", LineMethod::edge_following},
    {"back-and-forth", LineMethod::back_and_forth}};

std::string method_names() {
  std::vector<std::string> names;
  for (const auto& [name, method] : kMethods) names.push_back(name);
  return fmt::format("{}", fmt::join(names, ", "));
}

LineMethod method_of(const std::string& name) {
  for (const auto& [known, method] : kMethods) {
    if (known == name) return method;
  }
  throw UsageError(fmt::format("--method {}: no such lines; choose of {}", name, method_names()));
}

LineDesignOptions design_options(const LinesCommand& c) {
  if (!(c.opening_deg > 0.0 && c.opening_deg < 180.0)) {
    throw UsageError(fmt::format(
        "--max-opening {:g}; must lie between 0 and 180 degrees, both excluded", c.opening_deg));
  }
  LineDesignOptions options;
  options.overlap = c.overlap_pct / 100.0;
  options.most_missed = c.missed_pct / 100.0;
  if (c.survey.heading_deg) options.heading = Angle::degrees(*c.survey.heading_deg);
  check(options);
  return options;
}

/// Only what the lines depend on.
Provenance provenance(const LinesCommand& c, const std::string& hash, double draft_m) {
  Provenance p;
  p.version = SWATHPLAN_VERSION;
  p.command = "lines";
  p.input_file = c.site.file.string();
  p.input_hash = hash;
  p.options = {{"max_opening_deg", c.opening_deg},
               {"draft_m", draft_m},
               {"overlap_pct", c.overlap_pct},
               {"missed_pct", c.missed_pct},
               {"run_out_margin_m", c.site.run_out_margin_m}};
  if (c.survey.heading_deg) p.options.emplace_back("heading_deg", *c.survey.heading_deg);
  return p;
}

nlohmann::ordered_json figures_json(const std::string& method, const DesignedLines& d) {
  return {{"method", method},
          {"how", d.what},
          {"lines", d.figures.lines},
          {"closing_passes", d.passes},
          {"length_m", d.figures.length_m},
          {"least_length_m", d.figures.least_m},
          {"length_ratio_to_least", d.figures.ratio()},
          {"missed_pct", 100.0 * d.figures.missed},
          {"overlap_pct", 100.0 * d.figures.overlap}};
}

std::string row(const std::string& method, const DesignedLines& d) {
  return fmt::format("{:<15} {:>6} {:>6} {:>11.0f} {:>8.4f} {:>9.4f} {:>9.2f}  {}\n", method,
                     d.figures.lines, d.passes, d.figures.length_m, d.figures.ratio(),
                     100.0 * d.figures.missed, 100.0 * d.figures.overlap, d.what);
}

/// Says that a method could not do what was asked for; empty where it could.
std::string missed_note(const std::string& method, const DesignedLines& d, double allowed_pct) {
  if (100.0 * d.figures.missed <= allowed_pct) return {};
  return fmt::format(
      "note: {}: misses {:.3f} % where --missed {:g} was asked for; what shoals or ragged edges "
      "leave costs many lines: allow more, or use 'plan' in confined water\n",
      method, 100.0 * d.figures.missed, allowed_pct);
}

void write_lines(const std::filesystem::path& folder, const DesignedLines& designed,
                 const Site& site, const DesignGround& judge, const LinesCommand& c) {
  const Frame& frame = site.seafloor().frame;
  const Route route =
      route_of(designed, site.water, Angle::degrees(c.opening_deg), vehicle_of(c.survey));
  write_route_csv(folder / "route.csv", route, frame);
  write_route_geojson(folder, route, frame);
  write_exports(folder, route, site, export_options(c.exports), c.output.quiet);
  write_lines_png(folder / "lines.png", judge.swaths, designed.lines,
                  fmt::format("{}\n{:.1f} km, {:.3f} of the least, {:.3f} % missed", designed.what,
                              designed.figures.length_m / 1000.0, designed.figures.ratio(),
                              100.0 * designed.figures.missed));
}

void run(const LinesCommand& c) {
  LineDesignOptions options = design_options(c);
  for (const std::string& name : c.methods) static_cast<void>(method_of(name));
  const ExportOptions exports = export_options(c.exports);
  const Vehicle vehicle = vehicle_of(c.survey);
  const auto site = load_site(c.site, vehicle);
  check_export_crs(exports.formats, site->seafloor().frame);
  print_notes(*site, c.output.quiet);
  const PlanningGround planning = site->planning_ground(nullptr);
  const Angle opening = Angle::degrees(c.opening_deg);
  const DesignGround search(planning, opening, vehicle.draft_m, kSearchCells);
  const DesignGround judge(planning, opening, vehicle.draft_m, kJudgeCells);
  auto json = internal::to_json(provenance(c, site->imported.input_hash, vehicle.draft_m));
  json["methods"] = nlohmann::ordered_json::array();
  std::string table =
      fmt::format("{:<15} {:>6} {:>6} {:>11} {:>8} {:>9} {:>9}  {}\n", "method", "lines", "passes",
                  "length [m]", "ratio", "missed %", "overlap %", "how");
  std::string notes;
  for (const std::string& name : c.methods) {
    options.method = method_of(name);
    const DesignedLines designed = design_lines(planning, search, judge, options);
    write_lines(c.output.folder / name, designed, *site, judge, c);
    json["methods"].push_back(figures_json(name, designed));
    table += row(name, designed);
    notes += missed_note(name, designed, 100.0 * options.most_missed);
  }
  write_text_atomically(c.output.folder / "lines.json", internal::json_text(json));
  if (c.output.json) {
    fmt::print("{}", internal::json_text(json));
  } else if (!c.output.quiet) {
    fmt::print(stderr, "{}", notes);
    fmt::print("{}ratio: of the length to the area's integral of 1/W, turns left out\n", table);
  }
}

}  // namespace

void add_lines_command(CLI::App& app) {
  auto* sub = app.add_subcommand(
      "lines", "Lay survey lines in open water: swaths without rays, turns left out");
  auto command = std::make_shared<LinesCommand>();
  add_site_options(*sub, command->site);
  const std::string group = "Lines";
  sub->add_option("--method", command->methods, "Of " + method_names() + "; separated by commas")
      ->delimiter(',')
      ->capture_default_str()
      ->group(group);
  sub->add_option("--max-opening", command->opening_deg, "Full opening angle of the fan, degrees")
      ->capture_default_str()
      ->group(group);
  sub->add_option("--overlap", command->overlap_pct,
                  "Per cent of its swath that a line shares with its neighbour")
      ->capture_default_str()
      ->group(group);
  sub->add_option("--missed", command->missed_pct, "Per cent of the area that may be missed")
      ->capture_default_str()
      ->group(group);
  sub->add_option("--heading", command->survey.heading_deg,
                  "Azimuth of straight lines, degrees (default: searched)")
      ->group(group);
  sub->add_option("--vehicle", command->survey.vehicle, "Vehicle preset")
      ->capture_default_str()
      ->group(group);
  sub->add_option("--draft", command->survey.draft_m, "Draft and depth of the sonar, metres")
      ->group(group);
  sub->add_option("--margin", command->survey.margin_m, "Water wanted below the keel, metres")
      ->group(group);
  sub->add_option("--clearance", command->survey.clearance_m,
                  "Kept from walls, shoals and no-go areas, metres")
      ->group(group);
  add_export_options(*sub, command->exports);
  add_output_options(*sub, command->output);
  sub->callback([command] { run(*command); });
}

}  // namespace swathplan

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outlets/whole_folder.h"
#include "apps/outputs.h"
#include "apps/watch/terminal_watch.h"
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
  std::string profile = "survey";
  VehicleChoice vehicle;
  OutputOptions output;
  ExportChoice exports;
  std::vector<std::string> methods{"auto"};
  double opening_deg = 120.0, overlap_pct = 0.0, missed_pct = 0.05;
  std::optional<double> heading_deg;
  std::string north = "true";
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
  LineDesignOptions options;
  options.overlap = c.overlap_pct / 100.0;
  options.most_missed = c.missed_pct / 100.0;
  check(options);
  return options;
}

/// The rows of this command alone.
OptionTable own_options(LinesCommand& c) {
  const std::string group = "Lines";
  const std::vector<std::string> straight{"auto", "straight", "back-and-forth"};
  return {profile_option(c.profile),
          chooser(texts("--method", group, c.methods,
                        "Of " + method_names() + "; separated by commas", "method")),
          real("--max-opening", group, c.opening_deg, kDegrees, between(0.0, 180.0),
               "Full opening angle of the fan, degrees", "max_opening_deg"),
          real("--overlap", group, c.overlap_pct, kPerCent, within(0.0, 40.0),
               "Per cent of its swath that a line shares with its neighbour", "overlap_pct"),
          real("--missed", group, c.missed_pct, kPerCent, between(0.0, 100.0),
               "Per cent of the area that may be missed", "missed_pct"),
          used_by(straight,
                  real("--heading", group, c.heading_deg, kDegrees, any_number(),
                       "Azimuth of straight lines, degrees (default: searched)", "heading_deg")),
          used_by(straight, north_option(group, c.north))};
}

/// The rows of the vehicle that lines depend on.
OptionTable boat_options(VehicleChoice& vehicle) {
  return only(vehicle_options(vehicle),
              {"--vehicle", "--draft", "--margin", "--squat", "--clearance", "--turn-radius",
               "--speed", "--transit-speed"});
}

Provenance provenance_of(const LinesCommand& c, const Vehicle& vehicle, const std::string& hash) {
  Provenance provenance = provenance_of("lines", c.site, hash);
  LinesCommand typed = c;
  VehicleChoice now = in_force(c.vehicle, vehicle);
  record(provenance, own_options(typed));
  record(provenance, boat_options(typed.vehicle), boat_options(now));
  record(provenance, exporting_options(typed.exports));
  return provenance;
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

/// A note if a method misses more than was asked for; else empty.
std::string missed_note(const std::string& method, const DesignedLines& d, double allowed_pct) {
  if (100.0 * d.figures.missed <= allowed_pct) return {};
  return fmt::format(
      "{}: misses {:.3f} % of the area, more than --missed {:g} allows; shoals and ragged edges "
      "leave gaps that cost many lines: allow more, or use 'plan' in confined water",
      method, 100.0 * d.figures.missed, allowed_pct);
}

/// Returns why exports are left out, else nothing; `unserved`: the polygons without a line.
std::string write_lines(const std::filesystem::path& folder, const DesignedLines& designed,
                        const Site& site, const DesignGround& judge, const Vehicle& vehicle,
                        const ExportOptions& exports, const LinesCommand& c,
                        std::string& unserved) {
  const Frame& frame = site.seafloor().frame;
  const Route route = route_of(designed, site.water, Angle::degrees(c.opening_deg), vehicle);
  unserved = unserved_note(site, route);
  WrittenExports exported;
  write_all_or_none(folder, [&](const std::filesystem::path& staging) {
    write_route_csv(staging / "route.csv", route, frame);
    write_route_geojson(staging, route, frame);
    exported = write_exports(staging, route, site, exports);
    write_lines_png(staging / "lines.png", judge.swaths, designed.lines,
                    fmt::format("{}\n{:.1f} km, {:.3f} of the least, {:.3f} % missed",
                                designed.what, designed.figures.length_m / 1000.0,
                                designed.figures.ratio(), 100.0 * designed.figures.missed));
    remove_old_survey(folder, site);
  });
  print_exports(std::move(exported.files), folder, route, c.output.quiet);
  return exported.why;
}

/// Says that the search was ended; empty if it was not.
std::string ended_note(const std::string& method, const DesignedLines& d) {
  if (!d.ended_early) return {};
  return fmt::format("{}: search ended early: these are the best lines of those tried", method);
}

/// Says what a small --missed costs; empty where lines lie about as far apart as was asked for.
std::string overlap_note(const std::string& method, const DesignedLines& d, const LinesCommand& c) {
  constexpr double kMuchPct = 50.0;
  const double overlap_pct = 100.0 * d.figures.overlap;
  if (overlap_pct < c.overlap_pct + kMuchPct) return {};
  return fmt::format(
      "{}: the {} lines overlap by {:.0f} %, {:.1f} times the least length: they are laid to miss "
      "no "
      "more than {:g} % of the area (--missed{}), and a few places, such as shoal ground or ragged "
      "edges, ask for that many; a larger --missed takes fewer",
      method, d.figures.lines, overlap_pct, d.figures.ratio(), c.missed_pct,
      c.missed_pct == LinesCommand{}.missed_pct ? ", the default" : "");
}

void run(const LinesCommand& c) {
  LineDesignOptions options = design_options(c);
  for (const std::string& name : c.methods) static_cast<void>(method_of(name));
  const ExportOptions exports = export_options(c.exports);
  const Vehicle vehicle = vehicle_of(c.vehicle);
  TerminalWatch watch(c.output.quiet, c.output.folder);
  const auto site = load_site(c.site, vehicle, Watch(watch));
  watch.rest();
  check_export_crs(exports.formats, site->seafloor().frame);
  options.grid_north = Angle::degrees(site->imported.convergence_deg);
  if (c.heading_deg) options.heading = grid_heading(*c.heading_deg, c.north, site->imported);
  print_notes(*site, c.output.quiet);
  check_folder(c.output.folder);
  const Ground planning = site->ground(nullptr);
  const Angle opening = Angle::degrees(c.opening_deg);
  watch.phase("measuring swaths");
  const DesignGround search(planning, opening, vehicle.draft_m, kSearchCells);
  const DesignGround judge(planning, opening, vehicle.draft_m, kJudgeCells);
  const Provenance provenance = provenance_of(c, vehicle, site->imported.input_hash);
  auto json = provenance_json(provenance);
  json["meridian_convergence_deg"] = site->imported.convergence_deg;
  json["methods"] = nlohmann::ordered_json::array();
  std::string table =
      fmt::format("{:<15} {:>6} {:>6} {:>11} {:>8} {:>9} {:>9}  {}\n", "method", "lines", "passes",
                  "length [m]", "ratio", "missed %", "overlap %", "how");
  std::string notes;
  watch.search();
  for (const std::string& name : c.methods) {
    if (watch.ended() && !json["methods"].empty()) {
      notes += fmt::format("note: {} is left out: the search ended early\n", name);
      continue;
    }
    options.method = method_of(name);
    watch.under(name);
    options.watch = Watch(watch);
    options.watch.phase("laying lines");
    const DesignedLines designed = design_lines(planning, search, judge, options);
    std::string unserved;
    watch.phase("writing results");
    const auto writing = watch.writing();
    const std::string left_out =
        write_lines(c.output.folder / name, designed, *site, judge, vehicle, exports, c, unserved);
    if (!unserved.empty()) unserved.insert(0, name + ": ");
    json["methods"].push_back(figures_json(name, designed));
    json["methods"].back()["exports_left_out"] =
        left_out.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(left_out);
    json["methods"].back()["notes"] = nlohmann::ordered_json::array();
    table += row(name, designed);
    for (const std::string& note :
         {missed_note(name, designed, 100.0 * options.most_missed), overlap_note(name, designed, c),
          unserved, ended_note(name, designed)}) {
      if (note.empty()) continue;
      json["methods"].back()["notes"].push_back(note);
      notes += fmt::format("note: {}\n", note);
    }
  }
  watch.rest();
  const auto writing = watch.writing();
  write_text_atomically(c.output.folder / "lines.json", json_text(json));
  write_survey_toml(c.output.folder, provenance);
  if (c.output.json) {
    fmt::print("{}", json_text(json));
  } else if (!c.output.quiet) {
    fmt::print(stderr, "{}", notes);
    fmt::print("{}ratio: of the length to the area's integral of 1/W, turns left out\n", table);
  }
}

}  // namespace

Command lines_command() {
  auto command = std::make_shared<LinesCommand>();
  return {
      "lines",
      "Lay survey lines in open water: swaths without rays, turns left out",
      joined({site_options(command->site), own_options(*command), boat_options(command->vehicle),
              exporting_options(command->exports), output_options(command->output)}),
      [command] { run(*command); },
      {}};
}

}  // namespace swathplan

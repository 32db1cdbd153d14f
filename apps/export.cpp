#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/exports.h"
#include "io/exports/exportable_route.h"
#include "io/files/crs.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

struct ExportCommand {
  std::filesystem::path route;
  std::string crs;
  ExportChoice choice;
  std::filesystem::path folder;
  bool quiet = false;
};

void run(const ExportCommand& command) {
  const ExportOptions options = export_options(command.choice);
  const std::string crs = command.crs.empty() ? "" : parse_crs(command.crs);
  const ExportableRoute route = read_exportable_route(command.route, crs);
  const std::filesystem::path folder =
      command.folder.empty() ? command.route.parent_path() : command.folder;
  const std::string stem = command.route.stem().string();
  check_export_crs(options.formats, route.geographic.frame);
  remove_exports(folder, stem, options.formats);
  const auto exported = export_route(folder, stem, route.geographic, route.planar, options);
  if (command.quiet) return;
  for (const std::string& note : route.notes) fmt::print(stderr, "note: {}\n", note);
  fmt::print("{}", export_table(exported));
  print_export_warnings(route.planar.route, exported);
}

}  // namespace

void add_export_command(CLI::App& app) {
  auto* sub = app.add_subcommand(
      "export", "Write a route as files that autopilots, chart systems and survey packages read");
  auto command = std::make_shared<ExportCommand>();
  sub->add_option("ROUTE", command->route, "route.csv, another CSV of points, or GeoJSON")
      ->required();
  sub->add_option("--format", command->choice.formats,
                  "Of " + export_format_names() + "; separated by commas")
      ->delimiter(',')
      ->required();
  sub->add_option("--tolerance", command->choice.tolerance_m,
                  "Leave out waypoints within this of the way, metres")
      ->capture_default_str();
  sub->add_option("--mission-items", command->choice.mission_items,
                  "waypoints: cut missions into parts of so many items; 0: do not")
      ->capture_default_str();
  sub->add_option("--crs", command->crs,
                  "CRS of x_m,y_m as EPSG:n or WKT, where ROUTE has no longitude and latitude");
  sub->add_option("-o,--output", command->folder, "Folder for the files (default: that of ROUTE)");
  sub->add_flag("--quiet", command->quiet, "Print nothing but errors");
  sub->callback([command] { run(*command); });
}

}  // namespace swathplan

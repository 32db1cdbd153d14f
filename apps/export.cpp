#include <fmt/format.h>

#include <memory>

#include "apps/commands.h"
#include "apps/exports.h"
#include "apps/outlets/whole_folder.h"
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

/// The route that was read must not be replaced by a thinner one of itself.
void check_keeps_route(const std::filesystem::path& route, const std::filesystem::path& folder,
                       const ExportOptions& options) {
  for (const ExportFormat format : options.formats) {
    std::error_code ignored;
    const std::filesystem::path file =
        folder / fmt::format("{}.{}", route.stem().string(), name(format));
    if (!std::filesystem::equivalent(file, route, ignored)) continue;
    throw UsageError(
        fmt::format("--format {} would replace '{}' itself: choose another folder "
                    "with -o",
                    name(format), route.string()));
  }
}

void run(const ExportCommand& command) {
  const ExportOptions options = export_options(command.choice);
  const std::string crs = command.crs.empty() ? "" : parse_crs(command.crs);
  const ExportableRoute route = read_exportable_route(command.route, crs);
  const std::filesystem::path folder =
      command.folder.empty() ? command.route.parent_path() : command.folder;
  const std::string stem = command.route.stem().string();
  check_export_crs(options.formats, route.geographic.frame);
  check_keeps_route(command.route, folder, options);
  std::string why;
  const ExportOptions kept = sailable_exports(route.planar.route, nullptr, options, why);
  if (kept.formats.empty()) {
    throw InvalidInput(fmt::format("'{}': {}", command.route.string(), why));
  }
  if (!why.empty()) fmt::print(stderr, "warning: {}\n", why);
  std::vector<ExportedRoute> exported;
  write_all_or_none(folder, [&](const std::filesystem::path& staging) {
    exported = export_route(staging, stem, route.geographic, route.planar, kept);
    remove_exports(folder, stem, options.formats);
  });
  if (command.quiet) return;
  move_names(exported, folder);
  for (const std::string& note : route.notes) fmt::print(stderr, "note: {}\n", in_flags(note));
  fmt::print("{}", export_table(exported));
  print_export_warnings(route.planar.route, exported);
}

}  // namespace

Command export_command() {
  auto command = std::make_shared<ExportCommand>();
  const std::string group;
  return {
      "export",
      "Write a route as files that autopilots, chart systems and survey packages read",
      {argument("ROUTE", command->route,
                "route.csv or another CSV, GeoJSON, .plan, .waypoints, GPX, KML, RTZ, LNW, RLN, "
                "asciiplan, DXF, GeoPackage, YAML of a ROS path"),
       required(texts("--format", group, command->choice.formats,
                      "Of " + export_format_names() + "; separated by commas", "format")),
       real("--tolerance", group, command->choice.tolerance_m, kMetres, at_least(0.0),
            "Leave out waypoints within this of the way, metres", "tolerance_m"),
       mission_items_option(group, command->choice),
       text("--crs", group, command->crs,
            "CRS of x_m,y_m as EPSG:n or WKT, where ROUTE has no longitude and latitude", "crs"),
       path("-o,--output", group, command->folder, "Folder for the files (default: that of ROUTE)",
            ""),
       flag("--quiet", group, command->quiet, "Print nothing but errors", "")},
      [command] { run(*command); },
      {}};
}

}  // namespace swathplan

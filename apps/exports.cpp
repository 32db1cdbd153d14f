#include "apps/exports.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/exports/survey_runs.h"

namespace swathplan {

ExportOptions export_options(const ExportChoice& choice) {
  ExportOptions options{{}, choice.tolerance_m, choice.mission_items};
  for (const std::string& name : choice.formats) options.formats.push_back(export_format(name));
  check(options);
  return options;
}

namespace {

/// The number of survey lines along which the fan changes.
std::size_t lines_of_changing_fan(const Route& route) {
  const std::vector<SurveyRun> runs = survey_runs(route);
  return static_cast<std::size_t>(std::count_if(runs.begin(), runs.end(), [&](const SurveyRun& r) {
    const auto begin = route.waypoints.begin();
    return std::any_of(begin + static_cast<std::ptrdiff_t>(r.first),
                       begin + static_cast<std::ptrdiff_t>(r.last),
                       [&](const Waypoint& w) { return w.fan != route.waypoints[r.first].fan; });
  }));
}

}  // namespace

std::string export_table(const std::vector<ExportedRoute>& exported) {
  std::string text;
  for (const ExportedRoute& e : exported) {
    const std::string& first = e.files.front().string();
    const std::string files =
        e.files.size() == 1 ? first
                            : fmt::format("{} to {}", first, e.files.back().filename().string());
    text += fmt::format("{}: {} of {} waypoints, at most {:.3f} m from the route\n", files,
                        e.waypoints, e.of, e.largest_distance_m);
  }
  return text;
}

void print_export_warnings(const Route& route, const std::vector<ExportedRoute>& exported) {
  const std::vector<Leg> all = legs(route);
  const auto infeasible = std::count_if(
      all.begin(), all.end(), [&](const Leg& leg) { return !route.waypoints[leg.first].feasible; });
  if (infeasible > 0) {
    fmt::print(
        stderr,
        "warning: {} leg{} of the route {} infeasible: no way was found that the vehicle can "
        "steer in safe water; the files hold {} as drawn\n",
        infeasible, infeasible == 1 ? "" : "s", infeasible == 1 ? "is" : "are",
        infeasible == 1 ? "it" : "them");
  }
  if (const std::size_t lines = lines_of_changing_fan(route); lines > 0) {
    fmt::print(
        stderr,
        "note: the exported files hold no opening angles; those of the route change along {} "
        "line{}, see port_deg,stbd_deg in route.csv\n",
        lines, lines == 1 ? "" : "s");
  }
  for (const ExportedRoute& e : exported) {
    for (const std::string& warning : e.warnings)
      fmt::print(stderr, "warning: {}\n", in_flags(warning));
  }
}

void write_exports(const std::filesystem::path& folder, const Route& route, const Site& site,
                   const ExportOptions& options, bool quiet) {
  remove_exports(folder, "route", all_export_formats());
  if (options.formats.empty()) return;
  const AreaQuery water(site.water);
  const PlacedRoute placed{route, site.seafloor().frame, &water};
  const auto exported = export_route(folder, "route", placed, placed, options);
  if (quiet) return;
  fmt::print(stderr, "{}", export_table(exported));
  print_export_warnings(route, exported);
}

}  // namespace swathplan

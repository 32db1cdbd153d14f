#include "apps/exports.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
        "line{}, see {}\n",
        lines, lines == 1 ? "" : "s", "port_deg,stbd_deg in route.csv, or the table .lines.csv");
  }
  for (const ExportedRoute& e : exported) {
    for (const std::string& warning : e.warnings)
      fmt::print(stderr, "warning: {}\n", in_flags(warning));
  }
}

namespace {

/// Metres of legs that must not be sailed.
double astray_m(const Route& route, const AreaQuery* water) {
  constexpr double kDust = 0.01;
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    const Waypoint& w = route.waypoints[i];
    if (w.feasible) continue;
    const Vec2& next = route.waypoints[i + 1].position;
    const double length = (next - w.position).norm();
    const double inside = water != nullptr             ? water->inside_length(w.position, next)
                          : w.kind == LegKind::transit ? 0.0
                                                       : length;
    if (length - inside > kDust) sum += length - inside;
  }
  return sum;
}

}  // namespace

ExportOptions sailable_exports(const Route& route, const AreaQuery* water,
                               const ExportOptions& options, std::string& why) {
  const double astray = astray_m(route, water);
  if (!(astray > 0.0)) return options;
  ExportOptions kept = options;
  std::erase_if(kept.formats, is_sailed);
  if (kept.formats.size() == options.formats.size()) return options;
  std::vector<std::string_view> left_out;
  for (const ExportFormat format : options.formats) {
    if (is_sailed(format)) left_out.push_back(name(format));
  }
  std::vector<std::string_view> others;
  for (const ExportFormat format : all_export_formats()) {
    if (!is_sailed(format)) others.push_back(name(format));
  }
  why = fmt::format(
      "no {} was written: {:.0f} m of the way between lines are marked infeasible{}, and a vehicle "
      "would sail them; {} can be had",
      fmt::join(left_out, ", "), astray, water != nullptr ? " and lead outside the safe water" : "",
      fmt::join(others, ", "));
  return kept;
}

WrittenExports write_exports(const std::filesystem::path& folder, const Route& route,
                             const Site& site, const ExportOptions& asked,
                             const std::string& stem) {
  if (asked.formats.empty()) return {};
  const AreaQuery water(site.water);
  std::string why;
  const ExportOptions options = sailable_exports(route, &water, asked, why);
  if (!why.empty()) fmt::print(stderr, "warning: {}\n", why);
  if (options.formats.empty()) return {{}, why};
  const PlacedRoute placed{route, site.seafloor().frame, &water};
  return {export_route(folder, stem, placed, placed, options), why};
}

void move_names(std::vector<ExportedRoute>& exported, const std::filesystem::path& folder) {
  for (ExportedRoute& e : exported) {
    for (std::filesystem::path& file : e.files) file = folder / file.filename();
  }
}

void print_exports(std::vector<ExportedRoute> exported, const std::filesystem::path& folder,
                   const Route& route, bool quiet) {
  if (quiet || exported.empty()) return;
  move_names(exported, folder);
  fmt::print(stderr, "{}", export_table(exported));
  print_export_warnings(route, exported);
}

}  // namespace swathplan

#include "io/exports/route_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "coverage/route/leg_table.h"
#include "coverage/route/thin_route.h"
#include "io/exports/geographic_route.h"
#include "io/exports/line_table.h"
#include "io/exports/mission_plan.h"
#include "io/exports/mission_waypoints.h"
#include "io/exports/planned_lines.h"
#include "io/exports/route_dxf.h"
#include "io/exports/route_gpkg.h"
#include "io/exports/route_gpx.h"
#include "io/exports/route_kml.h"
#include "io/exports/route_lnw.h"
#include "io/exports/route_ros.h"
#include "io/exports/route_rtz.h"
#include "io/exports/survey_runs.h"
#include "io/files/atomic_file.h"
#include "io/route/route_csv.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<ExportFormat, std::string_view>, 11> kNames{{
    {ExportFormat::waypoints, "waypoints"},
    {ExportFormat::plan, "plan"},
    {ExportFormat::gpx, "gpx"},
    {ExportFormat::rtz, "rtz"},
    {ExportFormat::kml, "kml"},
    {ExportFormat::asciiplan, "asciiplan"},
    {ExportFormat::lnw, "lnw"},
    {ExportFormat::rln, "rln"},
    {ExportFormat::dxf, "dxf"},
    {ExportFormat::gpkg, "gpkg"},
    {ExportFormat::yaml, "yaml"},
}};

/// A value that is no enumerator is a bug of the caller. No other format may stand in for it.
[[noreturn]] void throw_unknown_format() { throw std::logic_error("unknown format of an export"); }

std::string names_where(bool geographic, const char* separator) {
  std::string names;
  for (const auto& [format, text] : kNames) {
    if (is_geographic(format) == geographic)
      names += (names.empty() ? "" : separator) + std::string(text);
  }
  return names;
}

/// 'stem.waypoints', or 'stem-02.waypoints' for the second of ten or more parts.
fs::path part_name(const fs::path& folder, const std::string& stem, std::size_t part,
                   std::size_t parts) {
  const std::string number =
      parts == 1 ? "" : fmt::format("-{:0{}}", part + 1, std::to_string(parts).size());
  return folder / fmt::format("{}{}.waypoints", stem, number);
}

/// All files in a folder that are parts of the mission `stem`.
std::vector<fs::path> mission_parts(const fs::path& folder, const std::string& stem) {
  std::vector<fs::path> parts;
  std::error_code error;
  const fs::path where = folder.empty() ? fs::path(".") : folder;
  for (const auto& entry : fs::directory_iterator(where, error)) {
    const std::string file = entry.path().stem().string();
    const bool numbered =
        file.size() > stem.size() + 1 && file.starts_with(stem + "-") &&
        file.find_first_not_of("0123456789", stem.size() + 1) == std::string::npos;
    if (numbered && entry.path().extension() == ".waypoints") parts.push_back(entry.path());
  }
  return parts;
}

void write_missions(const fs::path& folder, const std::string& stem, const GeographicRoute& route,
                    const ExportOptions& options, ExportedRoute& done) {
  const std::vector<Mission> missions = mission_waypoints(route, options.mission_items);
  std::size_t longest = 0;
  for (std::size_t i = 0; i < missions.size(); ++i) {
    done.files.push_back(part_name(folder, stem, i, missions.size()));
    write_text_atomically(done.files.back(), missions[i].text);
    longest = std::max(longest, missions[i].items);
  }
  if (longest <= kArduPilotItems) return;
  done.warnings.push_back(fmt::format(
      "the mission has {} items, but ArduPilot's boards without a memory card hold {}: allow a "
      "larger tolerance, or cut it into parts with <mission items> {}",
      longest, kArduPilotItems, kArduPilotItems));
}

std::string text_of(ExportFormat format, const GeographicRoute& route, const std::string& stem,
                    const ExportOptions& options) {
  if (format == ExportFormat::plan) return mission_plan(route);
  if (format == ExportFormat::gpx) return route_gpx(route, stem);
  if (format == ExportFormat::rtz) return route_rtz(route, stem, options.tolerance_m);
  if (format == ExportFormat::kml) return route_kml(route, stem);
  if (format == ExportFormat::asciiplan) return route_asciiplan(route);
  throw_unknown_format();
}

std::size_t waypoints_on_lines(const Route& route) {
  std::size_t count = 0;
  for (const SurveyRun& run : survey_runs(route)) count += run.last - run.first + 1;
  return count;
}

void write_geographic(const fs::path& folder, const std::string& stem, const PlacedRoute& placed,
                      const ExportOptions& options, ExportedRoute& done) {
  const GeographicRoute route =
      geographic_route(placed.route, placed.frame, options.tolerance_m, placed.water);
  done.waypoints = route.route.waypoints.size();
  done.largest_distance_m = route.largest_distance_m;
  if (done.format == ExportFormat::waypoints) {
    write_missions(folder, stem, route, options, done);
    return;
  }
  const std::string text = text_of(done.format, route, stem, options);
  done.files.push_back(folder / fmt::format("{}.{}", stem, name(done.format)));
  write_text_atomically(done.files.back(), text);
  if (done.format == ExportFormat::asciiplan) {
    done.waypoints = waypoints_on_lines(route.route);
    done.of = waypoints_on_lines(placed.route);
  }
  if (done.format == ExportFormat::rtz && text.size() > kRtzBytes) {
    done.warnings.push_back(fmt::format(
        "the RTZ file has {} kB, but chart systems need not read more than {}: allow a larger "
        "tolerance",
        text.size() / 1024, kRtzBytes / 1024));
  }
}

void write_planar(const fs::path& folder, const std::string& stem, const PlacedRoute& planar,
                  const ExportOptions& options, ExportedRoute& done) {
  if (done.format == ExportFormat::gpkg) {
    // It holds the fans of all waypoints, so all waypoints stay.
    done.waypoints = done.of;
    done.files.push_back(folder / fmt::format("{}.{}", stem, name(done.format)));
    write_route_gpkg(done.files.back(), planar.route, planar.frame);
    return;
  }
  const ThinnedRoute thinned = thin_route(planar.route, options.tolerance_m, planar.water);
  done.waypoints = thinned.route.waypoints.size();
  done.largest_distance_m = thinned.largest_distance_m;
  done.files.push_back(folder / fmt::format("{}.{}", stem, name(done.format)));
  if (done.format == ExportFormat::dxf) {
    write_route_dxf(done.files.back(), thinned.route, planar.frame);
  } else if (done.format == ExportFormat::yaml) {
    write_text_atomically(done.files.back(), route_ros(thinned.route, planar.frame));
  } else if (done.format == ExportFormat::lnw || done.format == ExportFormat::rln) {
    done.waypoints = waypoints_on_lines(thinned.route);
    done.of = waypoints_on_lines(planar.route);
    write_text_atomically(done.files.back(), done.format == ExportFormat::lnw
                                                 ? route_lnw(thinned.route, planar.frame)
                                                 : route_rln(thinned.route, planar.frame));
  } else {
    throw_unknown_format();
  }
}

void check_route(const Route& route) {
  if (const auto why = fault(route)) throw InvalidInput("the route cannot be exported: " + *why);
}

}  // namespace

std::string_view name(ExportFormat format) {
  for (const auto& [known, text] : kNames) {
    if (known == format) return text;
  }
  throw_unknown_format();
}

std::vector<ExportFormat> all_export_formats() {
  std::vector<ExportFormat> all;
  all.reserve(kNames.size());
  for (const auto& [format, text] : kNames) all.push_back(format);
  return all;
}

std::string export_format_names() {
  return names_where(true, ", ") + ", " + names_where(false, ", ");
}

ExportFormat export_format(std::string_view text) {
  for (const auto& [format, known] : kNames) {
    if (known == text) return format;
  }
  throw UsageError(
      fmt::format("'{}' is no format for routes; choose of {}", text, export_format_names()));
}

bool is_geographic(ExportFormat format) {
  switch (format) {
    case ExportFormat::waypoints:
    case ExportFormat::plan:
    case ExportFormat::gpx:
    case ExportFormat::rtz:
    case ExportFormat::kml:
    case ExportFormat::asciiplan:
      return true;
    case ExportFormat::lnw:
    case ExportFormat::rln:
    case ExportFormat::dxf:
    case ExportFormat::gpkg:
    case ExportFormat::yaml:
      return false;
  }
  throw_unknown_format();
}

bool is_sailed(ExportFormat format) {
  return format == ExportFormat::yaml ||
         (is_geographic(format) && format != ExportFormat::asciiplan);
}

fs::path line_table_name(const std::string& stem) { return stem + ".lines.csv"; }

void check(const ExportOptions& options) {
  if (!(options.tolerance_m >= kLeastToleranceM && options.tolerance_m < 1e6)) {
    throw UsageError(
        fmt::format("the tolerance of exported routes is {:g} m; must be at least {:g}",
                    options.tolerance_m, kLeastToleranceM));
  }
  if (options.mission_items != 0 && options.mission_items < kFewestItems) {
    throw UsageError("mission items", fmt::format("{}", options.mission_items),
                     fmt::format("must be 0 (one file) or at least {}", kFewestItems));
  }
}

void check_export_crs(const std::vector<ExportFormat>& formats, const Frame& frame) {
  if (!frame.crs_wkt.empty()) return;
  for (const ExportFormat format : formats) {
    if (!is_geographic(format)) continue;
    throw InvalidInput(
        fmt::format("the format '{}' is in longitude and latitude, but the route has no coordinate "
                    "reference system: give it with <CRS> EPSG:n, or choose {}",
                    name(format), names_where(false, " or ")));
  }
}

std::vector<ExportedRoute> export_route(const fs::path& folder, const std::string& stem,
                                        const PlacedRoute& geographic, const PlacedRoute& planar,
                                        const ExportOptions& options) {
  check_export_crs(options.formats, geographic.frame);
  check_route(geographic.route);
  check_route(planar.route);
  std::vector<ExportedRoute> all;
  for (const ExportFormat format : options.formats) {
    ExportedRoute done{format, {}, 0, planar.route.waypoints.size(), 0.0, {}};
    if (is_geographic(format)) {
      write_geographic(folder, stem, geographic, options, done);
    } else {
      write_planar(folder, stem, planar, options, done);
    }
    all.push_back(std::move(done));
  }
  if (!all.empty()) {
    write_route_csv(leg_table_file(folder, stem), leg_table(planar.route), planar.frame);
  }
  const bool all_hold_fans = std::all_of(options.formats.begin(), options.formats.end(),
                                         [](ExportFormat f) { return f == ExportFormat::gpkg; });
  if (!all_hold_fans) {
    write_text_atomically(folder / line_table_name(stem), line_table(planar.route, planar.frame));
  }
  return all;
}

fs::path leg_table_file(const fs::path& folder, const std::string& stem) {
  return folder / (stem + ".legs.csv");
}

void remove_exports(const fs::path& folder, const std::string& stem,
                    const std::vector<ExportFormat>& formats) {
  std::error_code error;
  fs::remove(folder / line_table_name(stem), error);
  for (const ExportFormat format : formats) {
    std::vector<fs::path> files{folder / fmt::format("{}.{}", stem, name(format))};
    if (format == ExportFormat::waypoints) {
      for (const fs::path& part : mission_parts(folder, stem)) files.push_back(part);
    }
    for (const fs::path& file : files) fs::remove(file, error);
  }
  fs::remove(leg_table_file(folder, stem), error);
}

}  // namespace swathplan

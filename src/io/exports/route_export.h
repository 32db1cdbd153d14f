#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "coverage/route/route.h"
#include "mesh/plane/area_query.h"

namespace swathplan {

/// Files that autopilots, chart systems and survey packages read; see docs/exports.md.
enum class ExportFormat {
  waypoints,
  plan,
  gpx,
  rtz,
  kml,
  asciiplan,
  lnw,
  rln,
  dxf,
  gpkg,
  yaml  ///< ROS 2 nav_msgs/Path
};
/// The name on the command line, which is the file's extension too.
/// @throws std::logic_error for a value that is none of the formats, as every function here does.
[[nodiscard]] std::string_view name(ExportFormat format);
[[nodiscard]] std::vector<ExportFormat> all_export_formats();
/// All names, separated by commas.
[[nodiscard]] std::string export_format_names();
/// @throws UsageError for a name that is none; the message lists those that are.
[[nodiscard]] ExportFormat export_format(std::string_view name);
/// True for formats in longitude and latitude.
[[nodiscard]] bool is_geographic(ExportFormat format);

/// True for formats that a vehicle sails by: they hold the way between lines too.
[[nodiscard]] bool is_sailed(ExportFormat format);

/// What line_table() is written as, beside the exports: 'stem.lines.csv'.
[[nodiscard]] std::filesystem::path line_table_name(const std::string& stem);

struct ExportOptions {
  std::vector<ExportFormat> formats;
  /// How far the path of an exported route may lie from the planned one; at least kLeastToleranceM.
  double tolerance_m = 0.10;
  /// The most items of a mission. Home counts too. Longer missions are cut into parts. 0: one file.
  std::size_t mission_items = 0;
};
/// Files hold millimetres.
inline constexpr double kLeastToleranceM = 0.001;

/// A route and what its coordinates are.
struct PlacedRoute {
  Route route;
  Frame frame;
  const AreaQuery* water = nullptr;  ///< exported paths leave it no more than the route does
};

/// What was written for one format.
struct ExportedRoute {
  ExportFormat format;
  std::vector<std::filesystem::path> files;
  std::size_t waypoints, of;          ///< waypoints in the file, of so many in the planned route
  double largest_distance_m;          ///< no point of the exported path lies farther from the plan
  std::vector<std::string> warnings;  ///< one sentence each, for people
};

/// @throws UsageError that names the option, its value and the rule.
void check(const ExportOptions& options);
/// @throws InvalidInput if a format is in longitude and latitude and the frame has no CRS.
void check_export_crs(const std::vector<ExportFormat>& formats, const Frame& frame);

/// Where the table of the legs' kinds, logging, angles and speeds stands (leg_table.h).
[[nodiscard]] std::filesystem::path leg_table_file(const std::filesystem::path& folder,
                                                   const std::string& stem);

/// Writes the route as `stem.FORMAT` into `folder`, and its leg table as `stem.legs.csv`. Formats
/// in longitude and latitude are written from `geographic`. Formats in the coordinates of the input
/// file are written from `planar`. Both must be the same route. Where a format holds no fans or
/// speeds of lines, line_table() of the planar route is written beside it.
/// @throws InvalidInput as check_export_crs does, or if a route is not valid or a file cannot be
///   written.
[[nodiscard]] std::vector<ExportedRoute> export_route(const std::filesystem::path& folder,
                                                      const std::string& stem,
                                                      const PlacedRoute& geographic,
                                                      const PlacedRoute& planar,
                                                      const ExportOptions& options);

/// Removes what export_route wrote earlier under that name in these formats, and its leg table.
/// Otherwise somebody might sail an older route or a part of one.
void remove_exports(const std::filesystem::path& folder, const std::string& stem,
                    const std::vector<ExportFormat>& formats);

}  // namespace swathplan

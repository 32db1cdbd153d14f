#pragma once

#include <string>
#include <vector>

#include "apps/site.h"
#include "io/exports/route_export.h"

namespace swathplan {

/// @throws UsageError that names the option, its value and the rule.
[[nodiscard]] ExportOptions export_options(const ExportChoice& choice);

/// A line for each file: what was kept, and how far it lies from the plan at most.
[[nodiscard]] std::string export_table(const std::vector<ExportedRoute>& exported);

/// Prints warnings to stderr: legs that cannot be sailed as drawn, fans that the files do not hold,
/// and what each export warns of.
void print_export_warnings(const Route& route, const std::vector<ExportedRoute>& exported);

/// The options without the formats that a vehicle sails by, where the route holds a leg that must
/// not be sailed: one that is marked infeasible and leaves the water or, where no water is known, a
/// transit that is marked. `why` says so; it stays empty where nothing is left out.
[[nodiscard]] ExportOptions sailable_exports(const Route& route, const AreaQuery* water,
                                             const ExportOptions& options, std::string& why);

/// What write_exports left behind.
struct WrittenExports {
  std::vector<ExportedRoute> files;
  std::string why;  ///< formats are left out (sailable_exports), else empty
};
/// Writes the exports of a planned route beside its route.csv, kept to the site's safe water; they
/// are named after `stem`.
[[nodiscard]] WrittenExports write_exports(const std::filesystem::path& folder, const Route& route,
                                           const Site& site, const ExportOptions& options,
                                           const std::string& stem = "route");
/// Names the files as they are called in `folder`, for those that were moved there.
void move_names(std::vector<ExportedRoute>& exported, const std::filesystem::path& folder);
/// To stderr: the table of exports that now stand in `folder`, and their warnings.
void print_exports(std::vector<ExportedRoute> exported, const std::filesystem::path& folder,
                   const Route& route, bool quiet);

}  // namespace swathplan

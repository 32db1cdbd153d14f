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

/// Writes the exports of a planned route beside its route.csv and removes those of an older one.
/// Thinned paths stay in the site's safe water. A table of the exports goes to stderr if there are
/// any, and so do warnings.
void write_exports(const std::filesystem::path& folder, const Route& route, const Site& site,
                   const ExportOptions& options, bool quiet);

}  // namespace swathplan

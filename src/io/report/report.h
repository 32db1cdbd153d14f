#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "coverage/score.h"
#include "io/results/provenance.h"
#include "planners/pareto.h"

namespace swathplan {

/// A plan of the report; what it points to must outlive the call.
struct ReportPlan {
  std::string planner;
  const Route* route = nullptr;
  const Score* score = nullptr;
  const CoverageGrid* grid = nullptr;
  double planning_seconds = 0.0;
  std::vector<std::string> notes;
  std::vector<Outcome> choices;  ///< that the planner had; may be empty
  std::size_t chosen = 0;
  std::string chosen_why;
};

/// A depth region as the report draws it; local metres.
struct ReportRegion {
  Area outline;
  int band = 0;
  double mean_depth_m = 0.0, opening_deg = 0.0;
};

/// Where the plans lie; local metres. `seafloor` gives the frame, `depths` the map of depths.
struct ReportSite {
  std::string title;
  const Seafloor* seafloor = nullptr;
  const DepthQuery* depths = nullptr;
  Area survey_area, water, no_go;
  Vehicle vehicle;
  std::vector<ReportRegion> regions;
  std::vector<std::pair<Vec2, Vec2>> gates, blocked_edges;
  Provenance provenance;
};

/// One self-contained page that opens offline: what each plan covers and misses side by side, the
/// map with path, regions and gates, what cannot be sailed as drawn and why, all figures, the
/// largest gaps, settings and provenance. Pictures are scaled down and paths simplified by less
/// than a pixel so that the page stays small.
[[nodiscard]] std::string report_html(const ReportSite& site, const std::vector<ReportPlan>& plans);

/// Writes it to a file.
/// @throws InvalidInput without a plan, or if the file cannot be written.
void write_report(const std::filesystem::path& path, const ReportSite& site,
                  const std::vector<ReportPlan>& plans);

}  // namespace swathplan

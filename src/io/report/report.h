#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coverage/judging/judged_survey.h"
#include "coverage/score.h"
#include "io/results/plan_record.h"
#include "io/results/provenance.h"

namespace swathplan {

/// A plan of the report. What it points to must outlive the call.
struct ReportPlan {
  const PlanRecord* record = nullptr;
  const Route* route = nullptr;
  const Score* score = nullptr;
  const CoverageGrid* grid = nullptr;
  double planning_seconds = 0.0;
  const JudgedSurvey* judged = nullptr;  ///< by a criterion; null: it was not
};

/// Where the plans lie, in local metres. `seafloor` gives the frame, `depths` the map of depths.
struct ReportSite {
  std::string title;
  const Seafloor* seafloor = nullptr;
  const DepthQuery* depths = nullptr;
  Area survey_area, water, no_go;
  Provenance provenance;
};

/// One self-contained page that opens offline. It begins with the verdict on the best plan in a
/// surveyor's words and the table of all plans. A map shows the plan that is chosen: depth, slope,
/// soundings a cell or TVU below; lines, swaths, gaps by their outline, what cannot be sailed as
/// drawn, safe water and no-go areas above; a boat sails it on a slider of time. Tables of lines,
/// gaps, rules and all figures follow, charts, settings and provenance. Regions and gates are those
/// of the last plan that has gates, else of the last one with regions. Pictures are scaled down,
/// and paths simplified by less than a pixel, so that the page stays small.
[[nodiscard]] std::string report_html(const ReportSite& site, const std::vector<ReportPlan>& plans);

/// Which of several plans is the best, and why, in one sentence, as the page has it; empty for a
/// single one.
[[nodiscard]] std::string best_of_plans(const std::vector<ReportPlan>& plans);

/// Writes it to a file.
/// @throws InvalidInput without a plan, or if the file cannot be written.
void write_report(const std::filesystem::path& path, const ReportSite& site,
                  const std::vector<ReportPlan>& plans);

}  // namespace swathplan

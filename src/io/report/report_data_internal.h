#pragma once

#include <nlohmann/json.hpp>

#include "io/report/report.h"

namespace swathplan::internal {

/// All that the page's scripts draw. Coordinates are whole centimetres from the lower-left corner
/// of `box_m`. A line is [x, y, dx, dy, ...]: each point is given by its step from the one before.
[[nodiscard]] nlohmann::ordered_json report_data(const ReportSite& site,
                                                 const std::vector<ReportPlan>& plans);

}  // namespace swathplan::internal

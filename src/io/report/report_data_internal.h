#pragma once

#include <nlohmann/json.hpp>

#include "io/report/report.h"

namespace swathplan::internal {

/// All that the page's scripts draw. Lengths are whole centimetres from the lower-left corner of
/// `box_m`; a line is [x, y, dx, dy, ...], each point as its step from the one before.
[[nodiscard]] nlohmann::ordered_json report_data(const ReportSite& site,
                                                 const std::vector<ReportPlan>& plans);

}  // namespace swathplan::internal

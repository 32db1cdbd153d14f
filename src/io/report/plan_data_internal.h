#pragma once

#include <nlohmann/json.hpp>

#include "io/report/pen_internal.h"
#include "io/report/pictures_internal.h"
#include "io/report/report.h"
#include "io/report/verdict_internal.h"

namespace swathplan::internal {

/// What the page is told of one of `count` plans: verdict, figures, legs, swaths, pictures.
[[nodiscard]] nlohmann::ordered_json plan_json(const ReportPlan& plan, const ReportSite& site,
                                               const Pen& pen, double tolerance_m,
                                               std::size_t count);

/// A picture with its palette, and where it lies.
[[nodiscard]] nlohmann::ordered_json picture_json(const IndexedPicture& picture,
                                                  const std::string& png,
                                                  nlohmann::ordered_json box);
/// Colours as '#rrggbb'; empty for one that is not drawn.
[[nodiscard]] nlohmann::ordered_json palette_json(const std::vector<Rgba>& palette);

[[nodiscard]] std::vector<ComparedPlan> compared(const std::vector<ReportPlan>& plans);

}  // namespace swathplan::internal

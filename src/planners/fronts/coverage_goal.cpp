#include "planners/fronts/coverage_goal.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace swathplan {
namespace {

/// Whether one of the marked cells lies within `reach` of cell i.
bool any_within(const WaterRaster& raster, const std::vector<char>& marked, std::size_t i,
                double reach) {
  const auto n = static_cast<std::ptrdiff_t>(reach / raster.cell_m());
  const auto columns = static_cast<std::ptrdiff_t>(raster.columns());
  const auto rows = static_cast<std::ptrdiff_t>(raster.rows());
  const std::ptrdiff_t c0 = static_cast<std::ptrdiff_t>(i) % columns;
  const std::ptrdiff_t r0 = static_cast<std::ptrdiff_t>(i) / columns;
  for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(0, r0 - n); r <= std::min(rows - 1, r0 + n);
       ++r) {
    for (std::ptrdiff_t c = std::max<std::ptrdiff_t>(0, c0 - n); c <= std::min(columns - 1, c0 + n);
         ++c) {
      if ((c - c0) * (c - c0) + (r - r0) * (r - r0) > n * n) continue;
      if (marked[static_cast<std::size_t>(r * columns + c)] != 0) return true;
    }
  }
  return false;
}

double coverable(const WaterRaster& raster, const AreaQuery& safe_water,
                 const PlanOptions& options) {
  std::vector<char> safe(raster.size(), 0);
  for (std::size_t i = 0; i < raster.size(); ++i) {
    safe[i] = raster.in_area(i) && safe_water.contains(raster.centre(i)) ? 1 : 0;
  }
  const double tangent = tan(options.sonar.max_opening / 2.0);
  std::size_t cells = 0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) {
    if (!raster.in_area(i)) continue;
    ++cells;
    const double below = std::max(0.0, raster.depth(i) - options.vehicle.draft_m);
    seen += safe[i] != 0 || any_within(raster, safe, i, below * tangent) ? 1U : 0U;
  }
  return cells > 0 ? static_cast<double>(seen) / static_cast<double>(cells) : 1.0;
}

}  // namespace

double coverage_goal_pct(const WaterRaster& raster, const AreaQuery& safe_water,
                         const PlanOptions& options) {
  const double usual = options.soundings > 1.0 ? kUsualGoalSeveral : kUsualGoal;
  return options.goal.coverage_pct.value_or(usual) * coverable(raster, safe_water, options);
}

}  // namespace swathplan

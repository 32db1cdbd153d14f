#include "coverage/judging/criterion_grids.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage/tracing/coverage_grid.h"
#include "mesh/base/error.h"
#include "mesh/base/parallel.h"

namespace swathplan {

namespace {

// The cell sizes of the depths that occur, shoalest first.
std::vector<double> cell_sizes(const Criterion& criterion, const DepthRange& depths) {
  std::vector<double> sizes;
  double from = -std::numeric_limits<double>::infinity();
  for (const CellRange& range : criterion.cells) {
    if (depths.max > from && depths.min <= range.to_depth_m) sizes.push_back(range.cell_m);
    from = range.to_depth_m;
  }
  return sizes;
}

void check_count(const Criterion& criterion, const std::vector<double>& sizes, const Area& area) {
  double count = 0.0;
  for (const double cell : sizes) {
    const GridSize size = grid_size(area, cell);
    count += static_cast<double>(size.columns) * size.rows;
  }
  if (count <= kMostJudgedCells) return;
  throw UsageError(
      "criteria", std::string(criterion.name),
      fmt::format("the survey area would hold {:.3g} of its cells from {:g} m on and the limit is "
                  "{:.3g}: judge a smaller <area>",
                  count, sizes.front(), kMostJudgedCells));
}

JudgedGrid grid_of(const Criterion& criterion, const Ground& ground, double cell) {
  const CoverageGrid mask(ground.survey_area, cell);
  JudgedGrid grid;
  grid.cell_m = cell;
  grid.origin = mask.origin();
  grid.columns = mask.columns();
  grid.rows = mask.rows();
  grid.cells.resize(mask.words().size());
  for_each_index(std::uint32_t{0}, grid.rows, [&](std::uint32_t row) {
    for (std::size_t i = std::size_t{row} * grid.columns, end = i + grid.columns; i < end; ++i) {
      if (!mask.counts(i)) continue;
      const std::optional<double> depth = ground.depths->depth(grid.centre(i));
      if (!depth) continue;
      grid.cells[i].depth_m = static_cast<float>(*depth);
      grid.cells[i].asked = cell_m(criterion, *depth) == cell;
    }
  });
  return grid;
}

}  // namespace

double data_spacing_m(const Seafloor& seafloor) {
  if (seafloor.faces.empty()) return 0.0;
  return std::sqrt(2.0 * plan_area_m2(seafloor) / static_cast<double>(seafloor.faces.size()));
}

std::vector<JudgedGrid> criterion_grids(const Criterion& criterion, const Ground& ground) {
  const std::vector<double> sizes = cell_sizes(criterion, depth_range(*ground.seafloor));
  check_count(criterion, sizes, ground.survey_area);
  std::vector<JudgedGrid> grids;
  for (const double cell : sizes) {
    grids.push_back(grid_of(criterion, ground, cell));
    const bool any = std::any_of(grids.back().cells.begin(), grids.back().cells.end(),
                                 [](const JudgedCell& c) { return c.asked; });
    if (!any) grids.pop_back();
  }
  return grids;
}

}  // namespace swathplan

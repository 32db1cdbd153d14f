#pragma once

#include <cstdint>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// Cells next to one another in one row of a grid: columns [first, end).
struct RowRun {
  std::uint32_t row = 0, first = 0, end = 0;
};

/// The outline of a set of cells, along the sides of cells, in the grid's frame: `origin` is the
/// grid's lower-left corner. `runs` go from the south up and in each row from the west, without
/// touching within a row; they must be connected by sides. No points for no runs.
/// Guarantees: (1) the polygon's area is that of the cells; (2) no two segments that follow one
/// another run in one direction; (3) rings meet in single points at most, so that the polygon is
/// valid where cells meet by corners only. O(n log n) for n sides.
[[nodiscard]] Polygon cell_outline(const std::vector<RowRun>& runs, const Vec2& origin,
                                   double cell_m);

/// Corners of all rings.
[[nodiscard]] std::size_t corner_count(const Polygon& polygon);

}  // namespace swathplan

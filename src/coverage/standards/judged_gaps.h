#pragma once

#include <cstdint>
#include <vector>

#include "coverage/standards/judge.h"

namespace swathplan {

/// One flag a cell of a grid, 0 or 1.
using CellMask = std::vector<std::uint8_t>;

/// The cells that a line, or two where 200 % is asked, did not see, as far as the criterion counts
/// them as a gap. None for a criterion without such gaps (GapRule::spread).
[[nodiscard]] CellMask gaps_in(const Criterion& criterion, const JudgedGrid& grid);
/// The cells with accepted soundings where a cube of the criterion may lie unseen: too few pings or
/// beams would strike it, side by side over its whole size. None without a rule of features.
[[nodiscard]] CellMask missed_cubes(const Criterion& criterion, const JudgedGrid& grid);

/// The cells of `lacking` that lie in a box of `side` x `side` such cells.
[[nodiscard]] CellMask in_boxes(const CellMask& lacking, const JudgedGrid& grid, int side);
/// The cells of `lacking` that lie in `length` such cells beside one another in a row or a column.
[[nodiscard]] CellMask in_rows(const CellMask& lacking, const JudgedGrid& grid, int length);
/// Distance from each cell's centre to that of the nearest cell of `seen`, in cells; infinite where
/// none is. O(cells), after Felzenszwalb and Huttenlocher (2012).
[[nodiscard]] std::vector<float> distance_in_cells(const CellMask& seen, const JudgedGrid& grid);
/// Cells that touch by a side make a place; largest first, then by their first cell.
[[nodiscard]] std::vector<FailingPlace> places_of(const CellMask& failing, const JudgedGrid& grid);

}  // namespace swathplan

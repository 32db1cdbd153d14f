#pragma once

#include <string_view>
#include <vector>

#include "coverage/coverage_grid.h"

namespace swathplan {

/// Why a gap is there.
enum class HolidayCause {
  between_beams,   ///< inside a swath: beams lie farther apart than the cells
  between_lines,   ///< footprints of no line reach it
  shadow,          ///< a swath passes over it but something stands before it
  edge             ///< along the outline of the survey area
};
[[nodiscard]] std::string_view name(HolidayCause cause);

/// A gap in coverage: a connected (4-neighbour) set of empty cells.
struct Holiday {
  std::size_t cells = 0;
  double area_m2 = 0.0;
  Vec2 position = Vec2::Zero();  ///< centre of a cell of the gap, the one nearest its centroid
  Box2 box;                      ///< extent of its cells
  HolidayCause cause = HolidayCause::between_lines;
};

struct HolidayOptions {
  double smallest_m2 = 0.0;      ///< smaller gaps are counted but not listed
  std::size_t list_at_most = 1000;
  bool logged_only = false;
};

struct Holidays {
  std::size_t count = 0;          ///< all of them
  double largest_m2 = 0.0;
  double total_m2 = 0.0;
  std::vector<Holiday> list;      ///< largest first (ties: south-west first)
};

/// Finds the gaps of a scored grid. O(cells), memory O(columns + gaps).
[[nodiscard]] Holidays find_holidays(const CoverageGrid& grid, const HolidayOptions& options);

}  // namespace swathplan

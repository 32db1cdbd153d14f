#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "coverage/tracing/coverage_grid.h"
#include "mesh/plane/polygons.h"

namespace swathplan {

/// Why a gap is there. The first of these that holds is given.
enum class HolidayCause {
  between_beams,  ///< footprints cover at least half of its cells: beams lie farther apart than
                  ///< cells
  no_line,        ///< it is all of a separate part of the survey area: no line serves that part
  edge,           ///< it touches the outline of the survey area
  between_lines   ///< no footprint reaches most of it: lines too far apart, or a shadow
};
[[nodiscard]] std::string_view name(HolidayCause cause);

/// A gap in coverage: a connected (4-neighbour) set of empty cells.
struct Holiday {
  std::size_t cells = 0;
  double area_m2 = 0.0;
  Vec2 position = Vec2::Zero();  ///< centre of a cell of the gap, the one nearest its centroid
  Box2 box;                      ///< extent of its cells
  HolidayCause cause = HolidayCause::between_lines;
  Polygon outline = {};  ///< along its cells; empty where none was asked for
};

struct HolidayOptions {
  double smallest_m2 = 0.0;  ///< smaller gaps are counted but not listed
  std::size_t list_at_most = 1000;
  bool logged_only = false;  ///< gaps of what logged legs cover
  /// Gaps get their outline, the largest first, until outlines hold so many corners. 0: none.
  std::size_t outline_corners = 0;
};

struct Holidays {
  std::size_t count = 0;  ///< all of them
  double largest_m2 = 0.0;
  double total_m2 = 0.0;
  std::vector<Holiday> list;  ///< largest first (ties: south-west first)
};

/// Finds the gaps of a scored grid. O(cells), memory O(columns + gaps).
[[nodiscard]] Holidays find_holidays(const CoverageGrid& grid, const HolidayOptions& options);

}  // namespace swathplan

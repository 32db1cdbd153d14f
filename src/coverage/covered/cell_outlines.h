#pragma once

#include <cstdint>
#include <vector>

#include "mesh/plane/polygons.h"

namespace swathplan {

/// Square cells of a lattice, row 0 the southernmost.
struct CellLattice {
  Vec2 origin = Vec2::Zero();  ///< lower-left corner
  double cell_m = 1.0;
  std::size_t columns = 0, rows = 0;
};

/// The area of the marked cells, one flag a cell, by its true outline: corners lie on the lattice.
/// Cells that meet at a corner only are apart. No marked cell gives an empty area. O(cells).
[[nodiscard]] Area outlines(const std::vector<std::uint8_t>& marked, const CellLattice& lattice);

}  // namespace swathplan

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coverage/covered/covered_before.h"
#include "io/grids/grid_import.h"

namespace swathplan {

/// Adds what the cells of a raster say was surveyed. Returns how they were taken, for people, and
/// extends `where` by the raster's extent, local metres.
[[nodiscard]] std::string add_raster(const GridCells& cells, const Frame& frame,
                                     CoveredBefore& before, Box2& where);

}  // namespace swathplan

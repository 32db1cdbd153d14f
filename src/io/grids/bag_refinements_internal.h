#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "io/grids/raster_internal.h"

namespace swathplan {

/// The refinement of one cell of the overview.
struct Refinement {
  std::size_t first = 0;  ///< of its nodes, in the list of all; rows from the south, west to east
  std::size_t columns = 0, rows = 0;
  Vec2 south_west = Vec2::Zero();  ///< its first node
  Vec2 step = Vec2::Zero();
};

struct Refinements {
  std::vector<Refinement> cells;
  std::vector<double> heights;
  std::size_t unrefined = 0;  ///< cells that hold an overview node only
  Raster overview;            ///< for its shape and its nodata values
};

/// The surface through all nodes, see read_refinements(). `path` is for messages.
[[nodiscard]] SurfaceData join_refinements(const Refinements& all,
                                           const std::filesystem::path& path);

}  // namespace swathplan

#pragma once

#include <optional>

#include "planners/passing/shown_cells.h"
#include "planners/rows/route_stretches.h"

namespace swathplan {

/// A route's stretches without what can be spared, and how much that was.
struct SparedStretches {
  std::vector<RouteStretch> stretches;  ///< joins beside what changed are left out
  std::size_t lines = 0;                ///< left out whole
  double ends_m = 0.0;                  ///< taken off the ends of others
};

/// Leaves out lines that `shown` can do without, the longest first, then ends of lines beside a
/// join. No line that stays gets shorter than `least_m`. `shown` holds the lines of this route, and
/// what is spared is taken out of it. Empty if nothing can be spared.
[[nodiscard]] std::optional<SparedStretches> spared(const Route& route, ShownCells& shown,
                                                    double least_m);

}  // namespace swathplan

#pragma once

#include <vector>

#include "planners/fitted/itinerary.h"
#include "planners/fitted/line_workshop.h"
#include "planners/passing/shown_cells.h"

namespace swathplan {

/// A cell that must be seen once more, or twice.
struct GapCell {
  Vec2 position = Vec2::Zero();  ///< its centre, local metres
  double depth_m = 0.0;
  int lines = 1;                    ///< that must still see it
  std::size_t grid = 0, index = 0;  ///< which of the criterion's grids it is of, and which cell
};

struct GapPassOptions {
  Unsteadiness unsteady;
  /// The share of a pass that a join may take off at either end: no cell counts on it, [0, 0.5).
  double end_share = 0.15;
  std::size_t fewest_cells = 1;  ///< a pass must see so many
  std::size_t most_passes = 600;
  /// Middles of passes that were tried and could not be joined: none is laid so near again.
  std::vector<Vec2> barred = {};
};
inline constexpr double kBarredM = 2.0;

/// Straight passes, each a line of two waypoints, and how many cells were left.
struct GapPasses {
  std::size_t passes = 0;
  std::size_t cells_left = 0;
};

/// Inserts passes into the itinerary from which the sonar sees the cells: no wall or shoal stands
/// between, on whichever side the boat is off as told, and the sonar's coverage curve reaches
/// there. A pass is no shorter than the options' least line, lies in `shop.lines_in()` and has room
/// to turn at its ends. The one that sees the most cells for the metres that it adds comes first.
[[nodiscard]] GapPasses insert_gap_passes(const std::vector<GapCell>& cells, LineWorkshop& shop,
                                          const GapPassOptions& options, Itinerary& itinerary);

}  // namespace swathplan

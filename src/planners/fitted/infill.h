#pragma once

#include <limits>

#include "planners/fitted/line_workshop.h"

namespace swathplan {

struct InfillOptions {
  /// A pass must bring this much new cover per metre of added path, as a share of the median W.
  double least_gain = 0.06;
  int most_passes = 200;
  double smallest_m2 = 0.0;  ///< smaller gaps get no pass
  /// No pass more once they promise so much new cover, square metres.
  double enough_m2 = std::numeric_limits<double>::infinity();
  double edge_share = 1.0;  ///< as hold_fans takes it
};

/// A route with extra passes over its gaps.
struct InfilledRoute {
  BuiltRoute built;
  std::size_t passes = 0;
  bool enough = false;  ///< they promise what was asked for
};

/// Adds straight passes over the gaps of any route. Passes are searched in kInfillHeadings
/// headings, where a swath of the local W sweeps the most empty cells for its metres. Each pass
/// goes between two lines where the detour is least; the order of the lines stays. The pass that
/// brings most comes first. The search ends when no pass is worth it, or none has room for the
/// turns onto it and away from it. Joins stay, except where a pass goes in between. `grid`: what
/// the route covers, as score() gives it. If no pass is worth it, the route comes back unchanged.
[[nodiscard]] InfilledRoute with_infill(const Route& route, const CoverageGrid& grid,
                                        LineWorkshop& shop, const InfillOptions& options = {});
/// The same for a route that was not scored yet. It is scored, gets passes and is scored again, up
/// to `rounds` times, until no pass pays or the coverage is `enough_pct`. `ground` needs its scene.
[[nodiscard]] InfilledRoute infilled(const Route& route, const Ground& ground,
                                     const PlanOptions& options, double enough_pct = 100.0,
                                     int rounds = 3);
inline constexpr int kInfillHeadings = 12;

}  // namespace swathplan

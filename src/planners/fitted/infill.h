#pragma once

#include "planners/fitted/line_workshop.h"

namespace swathplan {

struct InfillOptions {
  /// A pass must bring this much new cover per metre of added path, as a share of the median W.
  double least_gain = 0.06;
  int most_passes = 200;
  double smallest_m2 = 0.0;  ///< gaps smaller than this ask for no pass
};

/// A route with extra passes where it left gaps.
struct InfilledRoute {
  BuiltRoute built;
  std::size_t passes = 0;
};

/// Looks for straight passes in kInfillHeadings headings, each a run along which a swath of the
/// local W sweeps the most empty cells for its metres, and puts them between two lines where the
/// detour is least; the order of the route stays. One by one, the one that brings most first, until
/// none is worth it or has room for the turns onto it and away from it. Works on any route; its
/// joins are kept but where a pass goes in between. `grid`: what the route covers, as score() gives
/// it. Nothing worth it: the route itself.
[[nodiscard]] InfilledRoute with_infill(const Route& route, const CoverageGrid& grid,
                                        LineWorkshop& shop, const InfillOptions& options = {});
/// The same for a route from anywhere: scores it, adds passes, scores again, up to `rounds` times,
/// until none pays or the coverage is `enough_pct`. `ground` needs its scene.
[[nodiscard]] InfilledRoute infilled(const Route& route, const PlanningGround& ground,
                                     const PlanOptions& options, double enough_pct = 100.0,
                                     int rounds = 3);
inline constexpr int kInfillHeadings = 12;

}  // namespace swathplan

#pragma once

#include <cstddef>

#include "coverage/route/route.h"
#include "planners/steering/connect.h"

namespace swathplan {

/// Where two curves meet, chords of unequal length, or a sliver between them, ask for a tighter
/// turn than either curve (RouteFigures::min_turn_radius_m). Moves such waypoints along the path,
/// by less than a chord, until none asks for less than `radius_m`; the ends of a sliver become one.
/// What stays tighter (a corner, or no water to move in) is marked `feasible = false`.
/// Guarantees: (1) no bend but at a marked leg is tighter than `radius_m`; (2) both ends stay, and
/// what lay in the water does; (3) a route without tight bends comes back as it is.
/// Cost: O(n), and a few hundred looks around each tight bend.
/// Returns the number of bends that were marked.
std::size_t even_bends(Route& route, double radius_m, const Connector& connector);

}  // namespace swathplan
